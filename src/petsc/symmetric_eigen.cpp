#include "ritz/petsc/symmetric_eigen.hpp"

#include <slepcsys.h>

#include <slepcblaslapack.h>

#include <string>
#include <vector>

#include "ritz/base/error.hpp"

namespace ritz::petsc {
namespace {

/// LAPACK's dsyevd. 'V': A becomes the vectors; 'N': A is used up.
Eigen::VectorXd decompose(char job, Eigen::MatrixXd& A) {
  auto n = static_cast<PetscBLASInt>(A.rows());
  Eigen::VectorXd values(n);
  if (n == 0) return values;
  if (!A.allFinite()) throw NumericalError("a small symmetric matrix, whose eigenvalues are sought, is not finite");
  const char part = 'L';
  PetscBLASInt info = 0, ask = -1, integers = 0;
  double reals = 0;
  LAPACKsyevd_(&job, &part, &n, A.data(), &n, values.data(), &reals, &ask, &integers, &ask, &info);
  std::vector<double> work(static_cast<std::size_t>(reals));
  std::vector<PetscBLASInt> counts(static_cast<std::size_t>(integers));
  auto room = static_cast<PetscBLASInt>(work.size());
  LAPACKsyevd_(&job, &part, &n, A.data(), &n, values.data(), work.data(), &room, counts.data(), &integers, &info);
  if (info != 0)
    throw NumericalError("the eigenvalues of a symmetric " + std::to_string(n) + " x " + std::to_string(n) +
                         " matrix did not converge");
  return values;
}

}  // namespace

SymmetricEigen symmetric_eigen(Eigen::MatrixXd A) {
  Eigen::VectorXd values = decompose('V', A);
  return {std::move(values), std::move(A)};
}

Eigen::VectorXd symmetric_eigenvalues(Eigen::MatrixXd A) { return decompose('N', A); }

}  // namespace ritz::petsc
