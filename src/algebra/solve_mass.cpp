#include "ritz/algebra/solve_mass.hpp"

#include <string>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::algebra {

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
