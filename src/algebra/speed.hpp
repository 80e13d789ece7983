// The speed of this machine, from short measurements.
#pragma once
#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {

/// Floating point operations per second of the loaded BLAS's dgemm on one rank.
double dgemm_rate();

/// Bytes per second that one rank reads from memory.
double memory_rate();

/// *Collective*. The time of a product of A with eight columns, s.
double panel_seconds(Mat A);

}  // namespace ritz::algebra
