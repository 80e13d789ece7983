// How fast this machine is, measured in a moment.
#pragma once
#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// Floating point operations a second of the loaded BLAS's dgemm on one rank.
double dgemm_rate();

/// Bytes a second that one rank reads from memory.
double memory_rate();

/// Seconds that A takes for eight columns at once. *Collective*.
double panel_seconds(Mat A);

}  // namespace ritz::petsc
