// How long a step an explicit integrator can take.
#pragma once
#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {

/// Throws InputError where an explicit integrator cannot take a step of `dt` seconds because of the frequency ω, rad/s.
void refuse_unstable(const Integrator& integrator, double omega, double dt);

}  // namespace ritz::runtime
