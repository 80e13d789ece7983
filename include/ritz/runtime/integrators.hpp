// The integrators of linear models, one file each in src/runtime. f is taken linear in time over a step where the
// method looks inside it. θ = ωΔt.
#pragma once
#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {

/// The solution itself, for a force that is linear in time over the step; any θ, any damping, λ = 0 included.
Integrator exact();
/// Backward differences of first order. Never gains energy; damps every frequency.
Integrator implicit_euler();
/// Average acceleration, β = ¼, γ = ½: second order, keeps the energy of an undamped linear model.
Integrator newmark();
/// Chung and Hulbert's method [CH93] with ρ∞ = 0.8: second order, damps θ → ∞ by 0.8 a step.
Integrator generalized_alpha();
/// Backward differences of second order; its first step is one of implicit Euler.
Integrator bdf2();
/// Explicit, second order; a step with θ > 2 throws InputError naming the longest stable step.
Integrator central_difference();
/// The average vector field, which for a linear force is the implicit midpoint rule: second order, keeps the energy.
Integrator avf();

}  // namespace ritz::runtime
