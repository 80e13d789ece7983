// What an integrator of a nonlinear model is. An implicit one turns a step into one equation for the change
// δ = z_{n+1} − z_n,
//
//   R(δ) = inertia δ + drag D δ + share F(δ) − target = 0,
//
// with F(δ) = f̃(z_n + point δ), or its mean over the step (AVF), and says how z', z'', ... follow from δ. A new one is
// the two functions of a Method, in a file of its own. An explicit one writes δ itself as the target, and advances by
// the acceleration z''_{n+1} = (I + Δt D/2)⁻¹ (f_{n+1} − f̃(z_n + δ) − D (z'_n + Δt z''_n / 2)).
#pragma once
#include <string_view>

#include "ritz/runtime/nonlinear.hpp"

namespace ritz::runtime {

enum class ForceRule : unsigned char { at_point, mean_of_step, explicit_step };

/// The reduced force over a step, Uᵀf, linear between its ends; each of r numbers.
template <class Scalar>
struct NonlinearLoad {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
};

/// The equation of one step. The vectors have their size already; `scratch` is the method's own.
template <class Scalar>
struct StepEquation {
  Scalar inertia = 0;  ///< 1/s²
  Scalar drag = 0;     ///< 1/s
  Scalar share = 1;    ///< of the internal force
  Scalar point = 1;    ///< where on the step the force is taken, 0 ... 1
  Vector<Scalar> target, scratch;
};

template <class Scalar>
struct Method {
  std::string_view name;
  History history;
  ForceRule rule;
  /// Writes the equation of a step of dt seconds from `state`.
  void (*equation)(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                   const NonlinearLoad<Scalar>& load, Scalar dt, StepEquation<Scalar>& equation);
  /// Advances the history by the step's solution: δ, or of an explicit method z''_{n+1}.
  void (*advance)(const Vector<Scalar>& solution, Scalar dt, NonlinearState<Scalar>& state);
};

/// Backward differences of first order. First order; damps every frequency.
template <class Scalar>
Method<Scalar> nonlinear_implicit_euler();
/// Average acceleration, β = ¼, γ = ½: second order. On nonlinear models its energy is not bounded.
template <class Scalar>
Method<Scalar> nonlinear_newmark();
/// Chung and Hulbert's method [CH93] with ρ∞ = 0.8, the internal force taken at the mixed point
/// α_f z_n + (1 − α_f) z_{n+1}: second order.
template <class Scalar>
Method<Scalar> nonlinear_generalized_alpha();
/// Backward differences of second order; its first step, and the first of another length, is one of implicit Euler.
template <class Scalar>
Method<Scalar> nonlinear_bdf2();
/// Explicit, second order. A step with ω_max Δt > 2 at rest is refused with an InputError naming the longest.
template <class Scalar>
Method<Scalar> nonlinear_central_difference();
/// The average vector field [QM08]: z' and the mean of f̃ over the straight step, by two Gauss points, exact for StVK:
/// second order; undamped, the energy changes by the loads' work alone, at any length of step.
template <class Scalar>
Method<Scalar> nonlinear_avf();

}  // namespace ritz::runtime
