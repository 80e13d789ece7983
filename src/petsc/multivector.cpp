#include "ritz/petsc/multivector.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/check.hpp"

namespace ritz::petsc {
namespace {

MPI_Comm comm_of(Mat A) { return PetscObjectComm(reinterpret_cast<PetscObject>(A)); }

/// A vector without storage of its own, laid over columns one after the other.
Vector placeholder(Mat A, PetscInt local, PetscInt block) {
  Vector v;
  check(VecCreateMPIWithArray(comm_of(A), block, local, PETSC_DECIDE, nullptr, v.out()));
  return v;
}

/// sqrt(x_jᵀ (M x)_j).
Eigen::VectorXd m_norms(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& mx) {
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(1, x.cols());
  if (x.rows() > 0) squares = x.cwiseProduct(mx).colwise().sum();
  parallel::sum_in_place(comm, squares);
  return squares.transpose().cwiseMax(0).cwiseSqrt();
}

}  // namespace

void apply_to_columns(Mat A, const ConstTallRef& x, TallRef y, const std::function<void(Vec from, Vec to)>& op) {
  PetscInt rows = 0, columns = 0, block = 1;
  check(MatGetLocalSize(A, &rows, &columns));
  check(MatGetBlockSize(A, &block));
  const Vector from = placeholder(A, columns, block), to = placeholder(A, rows, block);
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    check(VecPlaceArray(from, x.col(j).data()));
    check(VecPlaceArray(to, y.col(j).data()));
    op(from, to);
    check(VecResetArray(from));
    check(VecResetArray(to));
  }
}

void multiply(Mat A, const ConstTallRef& x, TallRef y) {
  apply_to_columns(A, x, y, [A](Vec from, Vec to) { check(MatMult(A, from, to)); });
}

Tall multiply(Mat A, const ConstTallRef& x) {
  PetscInt rows = 0;
  check(MatGetLocalSize(A, &rows, nullptr));
  Tall y(rows, x.cols());
  multiply(A, x, y);
  return y;
}

Eigen::MatrixXd inner(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& y) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(x.cols(), y.cols());
  if (x.rows() > 0) product.noalias() = x.transpose() * y;
  parallel::sum_in_place(comm, product);
  return product;
}

Eigen::VectorXd column_norms(MPI_Comm comm, const ConstTallRef& x) {
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(1, x.cols());
  if (x.rows() > 0) squares = x.colwise().squaredNorm();
  parallel::sum_in_place(comm, squares);
  return squares.transpose().cwiseSqrt();
}

Matrix as_dense(MPI_Comm comm, TallRef x) {
  Matrix dense;
  const auto rows = static_cast<PetscInt>(x.rows()), columns = static_cast<PetscInt>(x.cols());
  check(MatCreateDense(comm, rows, PETSC_DECIDE, PETSC_DECIDE, columns, x.data(), dense.out()));
  return dense;
}

int orthonormalise(Mat M, const ConstTallRef& against, TallRef x, double drop) {
  const MPI_Comm comm = comm_of(M);
  int kept = static_cast<int>(x.cols());
  Tall mx(x.rows(), x.cols());
  for (int pass = 0; pass < 3 && kept > 0; ++pass) {
    auto block = x.leftCols(kept);
    multiply(M, block, mx.leftCols(kept));
    const Eigen::VectorXd before = m_norms(comm, block, mx.leftCols(kept));
    if (against.cols() > 0) {
      block.noalias() -= against * inner(comm, against, mx.leftCols(kept));
      multiply(M, block, mx.leftCols(kept));
    }
    const Eigen::MatrixXd gram = inner(comm, block, mx.leftCols(kept));
    const Eigen::VectorXd norms = gram.diagonal().cwiseMax(0).cwiseSqrt();
    const Eigen::VectorXd scale = (norms.array() > drop * before.array()).select(norms.cwiseInverse(), 0);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * gram * scale.asDiagonal());
    const auto& values = eigen.eigenvalues();
    const double least = std::max(drop * drop, 1e-14) * values.tail(1)[0];
    const auto rank = static_cast<int>((values.array() > least).count());
    const Eigen::MatrixXd turn = scale.asDiagonal() * eigen.eigenvectors().rightCols(rank) *
                                 values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    x.leftCols(rank) = (block * turn).eval();
    kept = rank;
  }
  return kept;
}

}  // namespace ritz::petsc
