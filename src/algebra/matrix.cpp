#include "ritz/algebra/matrix.hpp"

#include <string>

#include "ritz/algebra/check.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::algebra {

std::int64_t rows(const Matrix& A) {
  PetscInt total = 0;
  check(MatGetSize(A, &total, nullptr));
  return total;
}

Eigen::VectorXd diagonal(Mat A) {
  Vector entries;
  const PetscScalar* values = nullptr;
  PetscInt rows = 0;
  check(MatGetLocalSize(A, &rows, nullptr));
  check(MatCreateVecs(A, nullptr, entries.out()));
  check(MatGetDiagonal(A, entries));
  check(VecGetArrayRead(entries, &values));
  Eigen::VectorXd copied = Eigen::Map<const Eigen::VectorXd>(values, rows);
  check(VecRestoreArrayRead(entries, &values));
  return copied;
}

double one_norm(const Matrix& A) {
  PetscReal norm = 0;
  check(MatNorm(A, NORM_INFINITY, &norm));
  return norm;
}

void add(const Matrix& A, double factor, const Matrix& B, Pattern pattern) {
  check(MatAXPY(A, factor, B, pattern == Pattern::same ? SAME_NONZERO_PATTERN : SUBSET_NONZERO_PATTERN));
}

Matrix copy(const Matrix& A) {
  Matrix copied;
  check(MatDuplicate(A, MAT_COPY_VALUES, copied.out()));
  return copied;
}

Tall solve_mass(Mat A, const ConstTallRef& b) {
  const MPI_Comm comm = comm_of(A);
  Solver ksp;
  check(KSPCreate(comm, ksp.out()));
  check(KSPSetType(ksp, KSPCG));
  check(PCSetType(preconditioner(ksp), PCJACOBI));
  check(KSPSetNormType(ksp, KSP_NORM_UNPRECONDITIONED));
  check(KSPSetTolerances(ksp, 1e-15, PETSC_DEFAULT, PETSC_DEFAULT, 2000));
  check(KSPSetOperators(ksp, A, A));
  const auto right = as_vectors(A, b), solution = as_vectors(A, Tall::Zero(b.rows(), b.cols()));
  Tall x(b.rows(), b.cols());
  for (std::size_t j = 0; j < right.size(); ++j) {
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    PetscReal norm = 0, start = 0;
    check(KSPSolve(ksp, right[j], solution[j]));
    check(KSPGetConvergedReason(ksp, &reason));
    check(KSPGetResidualNorm(ksp, &norm));
    check(VecNorm(right[j], NORM_2, &start));
    if (reason < 0 && !(norm <= 1e-12 * start))
      throw NumericalError("the solve with the mass matrix stopped at a residual of " + shown(norm, 3));
    const PetscScalar* values = nullptr;
    check(VecGetArrayRead(solution[j], &values));
    x.col(static_cast<Eigen::Index>(j)) = Eigen::Map<const Eigen::VectorXd>(values, x.rows());
    check(VecRestoreArrayRead(solution[j], &values));
  }
  return x;
}

}  // namespace ritz::algebra
