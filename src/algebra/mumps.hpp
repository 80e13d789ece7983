// The settings of MUMPS, wherever PETSc calls it.
#pragma once
#include <petscksp.h>

namespace ritz::algebra {

/// *Collective*. Makes LDLᵀ by MUMPS the preconditioner of `ksp`.
void use_mumps(KSP ksp);

/// *Collective*. The factor that `ksp`, whose operator is set, will compute; null if the user's options chose another
/// package.
Mat mumps_factor(KSP ksp);

/// *Collective*. To be called before the factorization. Switches off the parallel root, which would hide the signs of
/// its pivots from the inertia, and sets `spare` percent of extra workspace (0: MUMPS's default). The user's own
/// ICNTL(14) takes precedence.
void prepare_mumps(Mat F, PetscInt spare);

enum class MumpsFailure { memory, workspace, other };

/// Why the factorization into F failed: `memory`, `workspace` (which a larger ICNTL(14) cures) or `other`.
MumpsFailure mumps_failure(Mat F);

}  // namespace ritz::algebra
