// How fast this machine is, measured in a moment.
#pragma once

namespace ritz::petsc {

/// Floating point operations a second of the loaded BLAS's dgemm on one rank.
double dgemm_rate();

/// Bytes a second that one rank reads from memory.
double memory_rate();

}  // namespace ritz::petsc
