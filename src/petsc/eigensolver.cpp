#include "ritz/petsc/eigensolver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "ritz/petsc/check.hpp"
#include "ritz/petsc/csr.hpp"

namespace ritz::petsc {
namespace {

constexpr const char* prefix = "modes_";

MPI_Comm comm_of(Mat A) { return PetscObjectComm(reinterpret_cast<PetscObject>(A)); }

/// Copies of columns as PETSc vectors that fit A.
std::vector<Vector> as_vectors(Mat A, const ConstTallRef& columns) {
  std::vector<Vector> list(static_cast<std::size_t>(columns.cols()));
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    auto& v = list[static_cast<std::size_t>(j)];
    PetscScalar* values = nullptr;
    check(MatCreateVecs(A, v.out(), nullptr));
    check(VecGetArrayWrite(v, &values));
    std::copy_n(columns.col(j).data(), columns.rows(), values);
    check(VecRestoreArrayWrite(v, &values));
  }
  return list;
}

std::vector<Vec> raw(const std::vector<Vector>& list) { return {list.begin(), list.end()}; }

ST spectral_transformation(EPS eps) {
  ST st = nullptr;
  check(EPSGetST(eps, &st));
  return st;
}

/// PC cholesky by MUMPS under shift-invert.
void use_shift_invert(EPS eps, double shift) {
  const ST st = spectral_transformation(eps);
  KSP ksp = nullptr;
  PC pc = nullptr;
  check(STSetType(st, STSINVERT));
  check(EPSSetTarget(eps, shift));
  check(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  check(STGetKSP(st, &ksp));
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCCHOLESKY));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
}

void use_multigrid(EPS eps, Mat P) {
  const ST st = spectral_transformation(eps);
  KSP ksp = nullptr;
  PC pc = nullptr;
  check(STSetType(st, STPRECOND));
  if (P) check(STSetPreconditionerMat(st, P));
  check(EPSSetWhichEigenpairs(eps, EPS_SMALLEST_REAL));
  check(STGetKSP(st, &ksp));
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCGAMG));
  PetscReal threshold = 0.01;
  check(PCGAMGSetThreshold(pc, &threshold, 1));
}

EigenSolver create(MPI_Comm comm, EPSType type) {
  EigenSolver eps;
  check(EPSCreate(comm, eps.out()));
  check(EPSSetOptionsPrefix(eps, prefix));
  check(EPSSetProblemType(eps, EPS_GHEP));
  check(EPSSetType(eps, type));
  return eps;
}

void prepare(EPS eps, Mat K, Mat M, const std::vector<Vector>& deflated, int wanted, double tolerance) {
  check(EPSSetOperators(eps, K, M));
  check(EPSSetDimensions(eps, wanted, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(eps, tolerance, 1000));
  auto list = raw(deflated);
  if (!list.empty()) check(EPSSetDeflationSpace(eps, static_cast<PetscInt>(list.size()), list.data()));
  check(EPSSetFromOptions(eps));
}

EigenPairs solved(EPS eps, Mat K, int wanted) {
  check(EPSSolve(eps));
  EigenPairs pairs;
  PetscInt converged = 0, iterations = 0, rows = 0;
  check(EPSGetConverged(eps, &converged));
  check(EPSGetIterationNumber(eps, &iterations));
  check(MatGetLocalSize(K, &rows, nullptr));
  pairs.iterations = static_cast<int>(iterations);
  const int count = std::min<int>(wanted, converged);
  std::vector<double> values(static_cast<std::size_t>(count));
  Tall vectors(rows, count);
  Vector x;
  check(MatCreateVecs(K, x.out(), nullptr));
  for (int j = 0; j < count; ++j) {
    PetscScalar value = 0;
    const PetscScalar* entries = nullptr;
    check(EPSGetEigenpair(eps, j, &value, nullptr, x, nullptr));
    values[static_cast<std::size_t>(j)] = value;
    check(VecGetArrayRead(x, &entries));
    std::copy_n(entries, rows, vectors.col(j).data());
    check(VecRestoreArrayRead(x, &entries));
  }
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return values[static_cast<std::size_t>(a)] < values[static_cast<std::size_t>(b)];
  });
  pairs.values.resize(count);
  pairs.vectors.resize(rows, count);
  for (int j = 0; j < count; ++j) {
    pairs.values[j] = values[static_cast<std::size_t>(order[static_cast<std::size_t>(j)])];
    pairs.vectors.col(j) = vectors.col(order[static_cast<std::size_t>(j)]);
  }
  return pairs;
}

/// SLEPc's solvers stop on ‖r‖₂ of an M-normalised vector, which depends on units; divided by λ‖Mψ‖ it does not.
/// ‖Mψ‖ is taken as the root of M's mean diagonal, its size for a smooth ψ.
PetscErrorCode scaled_residual(EPS, PetscScalar value, PetscScalar, PetscReal residual, PetscReal* error, void* scale) {
  *error = residual / (std::max(std::abs(value), 1e-300) * *static_cast<double*>(scale));
  return 0;
}

double typical_norm(Mat M) {
  PetscScalar trace = 0;
  PetscInt rows = 0;
  check(MatGetTrace(M, &trace));
  check(MatGetSize(M, &rows, nullptr));
  return std::sqrt(trace / rows);
}

}  // namespace

EigenPairs krylov_schur(Mat K, Mat M, double shift, const ConstTallRef& deflated, int wanted, double tolerance) {
  const EigenSolver eps = create(comm_of(K), EPSKRYLOVSCHUR);
  use_shift_invert(eps, shift);
  const auto space = as_vectors(K, deflated);
  prepare(eps, K, M, space, wanted, tolerance);
  return solved(eps, K, wanted);
}

EigenPairs davidson(Mat K, Mat M, Mat P, const ConstTallRef& near_null, const ConstTallRef& deflated,
                    const ConstTallRef& start, int wanted, double tolerance) {
  const EigenSolver eps = create(comm_of(K), EPSGD);
  use_multigrid(eps, P);
  const auto modes = as_vectors(K, near_null);
  const auto list = raw(modes);
  NullSpace space;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      PetscScalar dot = 0;
      check(VecDot(list[i], list[j], &dot));
      check(VecAXPY(list[i], -dot, list[j]));
    }
    check(VecNormalize(list[i], nullptr));
  }
  check(MatNullSpaceCreate(comm_of(K), PETSC_FALSE, static_cast<PetscInt>(list.size()), list.data(), space.out()));
  check(MatSetNearNullSpace(P, space));
  const auto kept_out = as_vectors(K, deflated);
  const auto guesses = as_vectors(K, start);
  auto guess_list = raw(guesses);
  double scale = typical_norm(M);
  prepare(eps, K, M, kept_out, wanted, tolerance);
  if (!guess_list.empty())
    check(EPSSetInitialSpace(eps, static_cast<PetscInt>(guess_list.size()), guess_list.data()));
  check(EPSSetConvergenceTestFunction(eps, scaled_residual, &scale, nullptr));
  return solved(eps, K, wanted);
}

void read_eigensolver_options(MPI_Comm comm) {
  const Matrix tiny = tiny_identity(comm);
  for (const bool direct : {true, false}) {
    const EigenSolver eps = create(comm, direct ? EPSKRYLOVSCHUR : EPSGD);
    if (direct) use_shift_invert(eps, 0);
    else use_multigrid(eps, nullptr);
    check(EPSSetFromOptions(eps));
    KSP ksp = nullptr;
    check(STGetKSP(spectral_transformation(eps), &ksp));
    check(KSPSetOperators(ksp, tiny, tiny));
    check(KSPSetFromOptions(ksp));
    check(KSPSetUp(ksp));
  }
}

}  // namespace ritz::petsc
