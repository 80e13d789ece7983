#include "ritz/algebra/multivector.hpp"

#include <petscblaslapack.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/algebra/panel.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {

namespace {

constexpr Eigen::Index least_panel = 3;  ///< columns from which a panel, even a part of one, is faster

/// A vector without storage of its own, laid over columns one after the other.
Vector placeholder(Mat A, PetscInt local, PetscInt block) {
  Vector v;
  check(VecCreateMPIWithArray(comm_of(A), block, local, PETSC_DECIDE, nullptr, v.out()));
  return v;
}

void multiply_columns(Mat A, const ConstTallRef& x, TallRef y) {
  PetscInt rows = 0, columns = 0, block = 1;
  check(MatGetLocalSize(A, &rows, &columns));
  check(MatGetBlockSize(A, &block));
  const Vector from = placeholder(A, columns, block), to = placeholder(A, rows, block);
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    check(VecPlaceArray(from, x.col(j).data()));
    check(VecPlaceArray(to, y.col(j).data()));
    check(MatMult(A, from, to));
    check(VecResetArray(from));
    check(VecResetArray(to));
  }
}

void multiply_panels(Mat A, const ConstTallRef& x, TallRef y) {
  PanelProduct product(A);
  each_panel(x, y, [&](const Panel& from, Panel& to) { product.apply(from, to); });
}

/// sqrt(x_jᵀ (M x)_j).
Eigen::VectorXd m_norms(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& mx) {
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(1, x.cols());
  if (x.rows() > 0) squares = x.cwiseProduct(mx).colwise().sum();
  parallel::sum_in_place(comm, squares);
  return squares.transpose().cwiseMax(0).cwiseSqrt();
}

}  // namespace

void multiply(Mat A, const ConstTallRef& x, TallRef y) {
  const Eigen::Index panels = x.cols() < least_panel ? 0 : (x.cols() + panel_width - least_panel) / panel_width;
  const Eigen::Index in_panels = std::min<Eigen::Index>(panels * panel_width, x.cols());
  if (panels > 0) multiply_panels(A, x.leftCols(in_panels), y.leftCols(in_panels));
  if (in_panels < x.cols()) multiply_columns(A, x.rightCols(x.cols() - in_panels), y.rightCols(x.cols() - in_panels));
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
  gemm('T', 1, x, y, 0, product);
  parallel::sum_in_place(comm, product);
  return product;
}

Tall combine(const ConstTallRef& x, const Eigen::MatrixXd& c) {
  Tall product = Tall::Zero(x.rows(), c.cols());
  gemm('N', 1, x, c, 0, product);
  return product;
}

void subtract(TallRef y, const ConstTallRef& x, const Eigen::MatrixXd& c) { gemm('N', -1, x, c, 1, y); }

void normalise(TallRef x, const Eigen::LLT<Eigen::MatrixXd>& gram) {
  if (x.rows() > 0) gram.matrixU().solveInPlace<Eigen::OnTheRight>(x);
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

std::vector<Vector> as_vectors(Mat A, const ConstTallRef& x) {
  std::vector<Vector> list(static_cast<std::size_t>(x.cols()));
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    auto& v = list[static_cast<std::size_t>(j)];
    PetscScalar* values = nullptr;
    check(MatCreateVecs(A, v.out(), nullptr));
    check(VecGetArrayWrite(v, &values));
    std::copy_n(x.col(j).data(), x.rows(), values);
    check(VecRestoreArrayWrite(v, &values));
  }
  return list;
}

int orthonormalise(Mat M, const ConstTallRef& against, TallRef x, double drop) {
  const MPI_Comm comm = comm_of(M);
  int kept = static_cast<int>(x.cols());
  Tall mx(x.rows(), x.cols());
  bool clean = false;
  for (int pass = 0; pass < 3 && kept > 0 && !clean; ++pass) {
    auto block = x.leftCols(kept);
    multiply(M, block, mx.leftCols(kept));
    const Eigen::VectorXd before = m_norms(comm, block, mx.leftCols(kept));
    if (against.cols() > 0) {
      subtract(block, against, inner(comm, against, mx.leftCols(kept)));
      multiply(M, block, mx.leftCols(kept));
    }
    const Eigen::MatrixXd gram = inner(comm, block, mx.leftCols(kept));
    const Eigen::VectorXd norms = gram.diagonal().cwiseMax(0).cwiseSqrt();
    const Eigen::VectorXd scale = (norms.array() > drop * before.array()).select(norms.cwiseInverse(), 0);
    const auto [values, vectors] = symmetric_eigen(scale.asDiagonal() * gram * scale.asDiagonal());
    const double least = std::max(drop * drop, 1e-14) * values.tail(1)[0];
    const auto rank = static_cast<int>((values.array() > least).count());
    const Eigen::MatrixXd turn =
        scale.asDiagonal() * vectors.rightCols(rank) * values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    clean = pass > 0 && rank == kept && values[0] > 0.5 && (norms.array() > 0.5 * before.array()).all();
    x.leftCols(rank) = combine(block, turn);
    kept = rank;
  }
  return kept;
}

Tall accumulate(MPI_Comm comm, std::span<const std::int64_t> numbers, const ConstTallRef& values, int owned) {
  const std::vector<PetscInt> where(numbers.begin(), numbers.end());
  Tall sums(owned, values.cols());
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    Vector v;
    check(VecCreateMPI(comm, owned, PETSC_DETERMINE, v.out()));
    check(VecSetValues(v, static_cast<PetscInt>(where.size()), where.data(), values.col(j).data(), ADD_VALUES));
    check(VecAssemblyBegin(v));
    check(VecAssemblyEnd(v));
    const PetscScalar* entries = nullptr;
    check(VecGetArrayRead(v, &entries));
    std::copy_n(entries, owned, sums.col(j).data());
    check(VecRestoreArrayRead(v, &entries));
  }
  return sums;
}

}  // namespace ritz::algebra
