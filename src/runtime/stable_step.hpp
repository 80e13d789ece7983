// The longest stable step of explicit integrators.
#pragma once
#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {

/// Throws InputError when a step of `dt` seconds of an explicit integrator is unstable for the frequency ω, rad/s.
void refuse_unstable(const Integrator& integrator, double omega, double dt);

}  // namespace ritz::runtime
