#pragma once
#include <petscksp.h>

#include "ritz/petsc/check.hpp"

namespace ritz::petsc {

/// The preconditioner that `ksp` owns.
inline PC preconditioner(KSP ksp) {
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  return pc;
}

}  // namespace ritz::petsc
