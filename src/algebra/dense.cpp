#include "ritz/algebra/dense.hpp"

#include <slepcsys.h>

#include <slepcblaslapack.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ritz/base/error.hpp"

namespace ritz::algebra {
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

void gemm(char op, double alpha, const Eigen::Ref<const MatrixXd>& a, const Eigen::Ref<const MatrixXd>& b, double beta,
          Eigen::Ref<MatrixXd> c) {
  const auto rows = static_cast<PetscBLASInt>(c.rows()), columns = static_cast<PetscBLASInt>(c.cols());
  const auto depth = static_cast<PetscBLASInt>(b.rows());
  if (c.size() == 0 || depth == 0) return;  // BLAS refuses empty sides
  const auto lda = static_cast<PetscBLASInt>(a.outerStride()), ldb = static_cast<PetscBLASInt>(b.outerStride()),
             ldc = static_cast<PetscBLASInt>(c.outerStride());
  BLASgemm_(&op, "N", &rows, &columns, &depth, &alpha, a.data(), &lda, b.data(), &ldb, &beta, c.data(), &ldc);
}

void add_gram(Eigen::Ref<Eigen::MatrixXd> gram, const Eigen::Ref<const Eigen::MatrixXd>& y) {
  const auto n = static_cast<PetscBLASInt>(gram.rows()), depth = static_cast<PetscBLASInt>(y.cols());
  if (n == 0 || depth == 0) return;
  const auto ldy = static_cast<PetscBLASInt>(y.outerStride()), ldg = static_cast<PetscBLASInt>(gram.outerStride());
  const double one = 1;
  BLASsyrk_("U", "N", &n, &depth, &one, y.data(), &ldy, &one, gram.data(), &ldg);
}

}  // namespace ritz::algebra
