#include "ritz/petsc/svd.hpp"

#include <petscsys.h>

#include <petscblaslapack.h>

#include <algorithm>

#include "ritz/base/error.hpp"

namespace ritz::petsc {
namespace {

using Eigen::MatrixXd;

/// LAPACK's dgesvd. 'S': as many vectors as there are σ; 'A': all; 'N': none.
Eigen::VectorXd decompose(char left, char right, MatrixXd& A, MatrixXd& U, MatrixXd& Vt) {
  const auto m = static_cast<PetscBLASInt>(A.rows()), n = static_cast<PetscBLASInt>(A.cols());
  const auto ldu = std::max<PetscBLASInt>(1, static_cast<PetscBLASInt>(U.rows())),
             ldv = std::max<PetscBLASInt>(1, static_cast<PetscBLASInt>(Vt.rows()));
  Eigen::VectorXd sigma(std::min(m, n));
  PetscBLASInt info = 0, ask = -1;
  double size = 0;
  LAPACKgesvd_(&left, &right, &m, &n, A.data(), &m, sigma.data(), U.data(), &ldu, Vt.data(), &ldv, &size, &ask, &info);
  Eigen::VectorXd work(static_cast<Eigen::Index>(size));
  const auto room = static_cast<PetscBLASInt>(work.size());
  LAPACKgesvd_(&left, &right, &m, &n, A.data(), &m, sigma.data(), U.data(), &ldu, Vt.data(), &ldv, work.data(), &room,
               &info);
  if (info != 0)
    throw NumericalError("the singular value decomposition of a " + std::to_string(m) + " x " + std::to_string(n) +
                         " matrix did not converge");
  return sigma;
}

}  // namespace

SingularVectors left_singular_vectors(MatrixXd A) {
  MatrixXd U(A.rows(), std::min(A.rows(), A.cols())), none;
  if (A.size() == 0) return {Eigen::VectorXd(0), U};
  auto sigma = decompose('S', 'N', A, U, none);
  return {std::move(sigma), std::move(U)};
}

SingularVectors right_singular_vectors(MatrixXd A) {
  MatrixXd none, Vt(A.cols(), A.cols());
  if (A.size() == 0) return {Eigen::VectorXd(0), MatrixXd::Identity(A.cols(), A.cols())};
  auto sigma = decompose('N', 'A', A, none, Vt);
  return {std::move(sigma), Vt.transpose()};
}

MatrixXd nearest_orthogonal(MatrixXd A) {
  MatrixXd U(A.rows(), A.cols()), Vt(A.rows(), A.cols());
  if (A.size() > 0) decompose('A', 'A', A, U, Vt);
  return U * Vt;
}

}  // namespace ritz::petsc
