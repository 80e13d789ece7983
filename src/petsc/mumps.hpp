// What this project asks of MUMPS, wherever PETSc calls it.
#pragma once
#include <petscksp.h>

namespace ritz::petsc {

/// LDLᵀ by MUMPS as the preconditioner of `ksp`. *Collective*.
void use_mumps(KSP ksp);

/// The factor that `ksp`, which has its operator, makes, or null where the user's options chose another package.
/// *Collective*.
Mat mumps_factor(KSP ksp);

/// Before the factorization: no parallel root, which would hide its pivots' signs from the inertia, and `spare` percent
/// more workspace than foreseen (0: MUMPS's own choice). The user's own ICNTL(14) wins. *Collective*.
void prepare_mumps(Mat F, PetscInt spare);

enum class MumpsFailure { memory, workspace, other };

/// Why the factorization into F failed: no memory; too little workspace, which more of it (ICNTL(14)) helps; else.
MumpsFailure mumps_failure(Mat F);

}  // namespace ritz::petsc
