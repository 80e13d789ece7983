#include "ritz/algebra/mumps.hpp"

#include <string>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {
namespace {

constexpr PetscInt parallel_root = 13, workspace_margin = 14;  // ICNTL

}  // namespace

void use_mumps(KSP ksp) {
  check(KSPSetType(ksp, KSPPREONLY));
  check(PCSetType(preconditioner(ksp), PCCHOLESKY));
  check(PCFactorSetMatSolverType(preconditioner(ksp), MATSOLVERMUMPS));
}

Mat mumps_factor(KSP ksp) {
  PC pc = preconditioner(ksp);
  PetscBool factors = PETSC_FALSE;
  Mat F = nullptr;
  check(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(pc), &factors, PCCHOLESKY, PCLU, ""));
  if (!factors) return nullptr;
  check(PCFactorSetUpMatSolverType(pc));
  check(PCFactorGetMatrix(pc, &F));
  MatSolverType type = nullptr;
  check(MatFactorGetSolverType(F, &type));
  return std::string(type) == MATSOLVERMUMPS ? F : nullptr;
}

void prepare_mumps(Mat F, PetscInt spare) {
  check(MatMumpsSetIcntl(F, parallel_root, 1));
  if (spare > 0) check(MatMumpsSetIcntl(F, workspace_margin, spare));
}

MumpsFailure mumps_failure(Mat F) {
  PetscInt code = 0;
  check(MatMumpsGetInfog(F, 1, &code));
  if (code == -13 || code == -19) return MumpsFailure::memory;
  if (code == -8 || code == -9 || code == -17 || code == -20) return MumpsFailure::workspace;
  return MumpsFailure::other;
}

}  // namespace ritz::algebra
