#include "ritz/algebra/newton.hpp"

#include <cmath>
#include <exception>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/csr.hpp"
#include "ritz/algebra/factorization.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/algebra/multigrid.hpp"
#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {
namespace {

constexpr PetscInt most_spare = 800;  // percent of MUMPS's workspace
constexpr int most_iterations = 30;
constexpr double linear_tolerance = 1e-8;  ///< of the iterative solver, relative to Newton's residual

/// What the callbacks of one solve share. An exception may not cross PETSc's C: it waits here.
struct Call {
  const Equations& equations;
  double tolerance, scale;
  std::exception_ptr thrown = {};
  int tangents = 0;  ///< each of which is then factored
};

Tall values(Vec v) {
  PetscInt rows = 0;
  const PetscScalar* array = nullptr;
  check(VecGetLocalSize(v, &rows));
  check(VecGetArrayRead(v, &array));
  const Tall x = Eigen::Map<const Eigen::VectorXd>(array, rows);
  check(VecRestoreArrayRead(v, &array));
  return x;
}

void set_values(Vec v, const Tall& x) {
  PetscScalar* array = nullptr;
  check(VecGetArrayWrite(v, &array));
  Eigen::Map<Eigen::VectorXd>(array, x.rows()) = x.col(0);
  check(VecRestoreArrayWrite(v, &array));
}

template <class Work>
PetscErrorCode guarded(void* context, Work work) {
  auto& call = *static_cast<Call*>(context);
  try {
    work(call);
    return 0;
  } catch (...) {
    call.thrown = std::current_exception();
    return PETSC_ERR_USER;
  }
}

PetscErrorCode residual(SNES, Vec x, Vec r, void* context) {
  return guarded(context, [&](Call& call) {
    Tall values_of_r;
    call.equations.residual(values(x), values_of_r);
    set_values(r, values_of_r);
  });
}

PetscErrorCode tangent(SNES, Vec x, Mat, Mat, void* context) {
  return guarded(context, [&](Call& call) {
    call.equations.tangent(values(x));
    ++call.tangents;
  });
}

PetscErrorCode converged(SNES snes, PetscInt, PetscReal, PetscReal, PetscReal norm, SNESConvergedReason* reason,
                         void* context) {
  return guarded(context, [&](Call& call) {
    *reason = SNES_CONVERGED_ITERATING;
    if (!std::isfinite(norm)) *reason = SNES_DIVERGED_FNORM_NAN;
    else if (norm <= call.tolerance * call.scale) *reason = SNES_CONVERGED_FNORM_RELATIVE;
    else if (norm <= std::sqrt(call.tolerance) * call.scale) {
      Vec x = nullptr;
      check(SNESGetSolution(snes, &x));
      if (norm <= call.equations.rounding(values(x))) *reason = SNES_CONVERGED_FNORM_ABS;
    }
  });
}

KSP linear(SNES snes) {
  KSP ksp = nullptr;
  check(SNESGetKSP(snes, &ksp));
  return ksp;
}

void set_direct(KSP ksp, Mat A) {
  use_mumps(ksp);
  check(MatSetOptionsPrefixFactor(A, "solve_"));
}

void set_iterative(KSP ksp, Mat A, const ConstTallRef& near_null) {
  PC pc = preconditioner(ksp);
  attach_near_null(A, near_null);
  check(KSPSetType(ksp, KSPCG));
  check(KSPSetTolerances(ksp, linear_tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 1000));
  check(PCSetOptionsPrefix(pc, "multigrid_"));
  check(PCSetType(pc, PCGAMG));
  check(PCGAMGSetReuseInterpolation(pc, PETSC_TRUE));
}

NonlinearSolver make(MPI_Comm comm) {
  NonlinearSolver snes;
  SNESLineSearch search = nullptr;
  check(SNESCreate(comm, snes.out()));
  check(SNESSetOptionsPrefix(snes, "newton_"));
  check(SNESSetType(snes, SNESNEWTONLS));
  check(SNESSetTolerances(snes, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations, PETSC_DEFAULT));
  check(SNESGetLineSearch(snes, &search));
  check(SNESLineSearchSetType(search, SNESLINESEARCHBASIC));
  check(KSPSetOptionsPrefix(linear(snes), "solve_"));
  return snes;
}

void prepare_factor(KSP ksp, Mat A, PetscInt spare) {
  check(KSPSetOperators(ksp, A, A));
  if (Mat F = mumps_factor(ksp)) prepare_mumps(F, spare);
}

/// Whether the factorization failed for want of workspace, and is to be tried again with more. Throws where the memory
/// itself ran out: unlike a load or a step that is too large, it is not helped by halving these.
bool wants_workspace(KSP ksp) {
  Mat F = mumps_factor(ksp);
  if (!F) return false;
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(F, &error));
  if (error == MAT_FACTOR_NOERROR) return false;
  const MumpsFailure failure = mumps_failure(F);
  if (failure == MumpsFailure::memory)
    throw NumericalError("memory ran out in the factorization of the tangent", Reason::memory_for_factors);
  return failure == MumpsFailure::workspace;
}

bool indefinite(KSP ksp) {
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(ksp, &reason));
  return reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC;
}

SNESConvergedReason run(SNES snes, Call& call, Tall& x) {
  Mat J = nullptr;
  Vector solution;
  check(SNESGetJacobian(snes, &J, nullptr, nullptr, nullptr));
  check(MatCreateVecs(J, solution.out(), nullptr));
  set_values(solution, x);
  const PetscErrorCode code = SNESSolve(snes, nullptr, solution);
  if (call.thrown) {
    succeeds(code);
    std::rethrow_exception(call.thrown);
  }
  check(code);
  x = values(solution);
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  check(SNESGetConvergedReason(snes, &reason));
  return reason;
}

}  // namespace

Newton::Newton(Mat jacobian, LinearSolver solver, const ConstTallRef& near_null)
    : snes_(make(comm_of(jacobian))), jacobian_(jacobian), solver_(solver) {
  KSP ksp = linear(snes_);
  if (solver_ == LinearSolver::direct) set_direct(ksp, jacobian_);
  else set_iterative(ksp, jacobian_, near_null);
  check(SNESSetFromOptions(snes_));
  prepare_factor(ksp, jacobian_, spare_);
}

NewtonOutcome Newton::solve(const Equations& equations, double tolerance, double scale, Tall& x) {
  if (!std::isfinite(scale)) return {.reason = "the forces are not finite"};
  Call call{equations, tolerance, scale};
  check(SNESSetFunction(snes_, nullptr, residual, &call));
  check(SNESSetJacobian(snes_, jacobian_, jacobian_, tangent, &call));
  check(SNESSetConvergenceTest(snes_, converged, &call, nullptr));
  const Tall start = x;
  SNESConvergedReason reason = run(snes_, call, x);
  while (reason < 0 && wants_workspace(linear(snes_))) {
    spare_ *= 2;
    if (spare_ > most_spare)
      throw NumericalError("the factorization of the tangent wants more workspace", Reason::workspace_for_factors);
    check(PCReset(preconditioner(linear(snes_))));
    prepare_factor(linear(snes_), jacobian_, spare_);
    x = start;
    reason = run(snes_, call, x);
  }
  if (solver_ == LinearSolver::iterative && reason < 0 && indefinite(linear(snes_))) {
    x = start;
    check(KSPSetType(linear(snes_), KSPFGMRES));
    reason = run(snes_, call, x);
    check(KSPSetType(linear(snes_), KSPCG));
  }
  PetscInt iterations = 0;
  NewtonOutcome outcome;
  check(SNESGetIterationNumber(snes_, &iterations));
  check(SNESGetFunctionNorm(snes_, &outcome.residual));
  outcome.result = reason > 0 ? Convergence::converged : Convergence::failed;
  outcome.iterations = static_cast<int>(iterations);
  outcome.factorizations = call.tangents;
  outcome.reason = SNESConvergedReasons[reason];
  return outcome;
}

std::int64_t Newton::negative_pivots() const {
  PetscInt negative = 0;
  if (Mat F = mumps_factor(linear(snes_))) check(MatMumpsGetInfog(F, 12, &negative));
  return negative;
}

LinearAnswer Newton::solve_linear(const Tall& b) {
  KSP ksp = linear(snes_);
  Vector x, rhs;
  check(MatCreateVecs(jacobian_, x.out(), rhs.out()));
  set_values(rhs, b);
  check(KSPSetOperators(ksp, jacobian_, jacobian_));
  check(KSPSolve(ksp, rhs, x));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(ksp, &reason));
  if (reason == KSP_DIVERGED_PC_FAILED) return {values(x), false};
  PetscReal energy = 0;
  check(VecDot(x, rhs, &energy));
  return {values(x), negative_pivots() > 0 || indefinite(ksp) || energy < 0};
}

void read_newton_options(MPI_Comm comm) {
  const NonlinearSolver snes = make(comm);
  check(SNESSetFromOptions(snes));
}

}  // namespace ritz::algebra
