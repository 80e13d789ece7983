// The integrators of nonlinear models, each by its coefficients for a step of unit length.
//
// The generalised-α family over the change δ of a step; Newmark's method is α_m = α_f = 0.
//   z''_{n+1} = (δ − Δt z' − (½ − β) Δt² z'') / βΔt²,  z'_{n+1} = z' + Δt ((1 − γ) z'' + γ z''_{n+1}),
//   mix(α_m; z'') + D mix(α_f; z') + f̃(mix(α_f; z)) = mix(α_f; f),  mix(α; x) = α x_n + (1 − α) x_{n+1}.
// With β = 0, γ = ½ it is the central difference with velocities at whole steps, which is explicit.
#include "ritz/runtime/integrator.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::runtime {
namespace {

struct NewmarkFamily {
  double beta, gamma;
  double alpha_m = 0, alpha_f = 0;
};

constexpr NewmarkFamily average_acceleration{.beta = 0.25, .gamma = 0.5};

/// The optimal member of given damping ρ∞ of the highest frequencies, [CH93] Eqs. 17, 18, 25.
constexpr NewmarkFamily chung_hulbert(double rho) {
  const double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
  const double surplus = 1 - alpha_m + alpha_f;
  return {.beta = surplus * surplus / 4, .gamma = surplus - 0.5, .alpha_m = alpha_m, .alpha_f = alpha_f};
}

ImplicitStep<> member(const NewmarkFamily& method) {
  const auto [beta, gamma, alpha_m, alpha_f] = method;
  const double now_m = 1 - alpha_m, now_f = 1 - alpha_f;
  const double share = (0.5 - beta) / beta;  // of z'', which the new one turns about
  ImplicitStep<> step{.inertia = now_m / beta, .drag = now_f * gamma / beta, .point = now_f};
  step.acceleration.head<3>() << 0, now_m / beta, now_m * share - alpha_m;
  step.velocity.head<3>() << 0, now_f * gamma / beta - 1, now_f * (gamma * share - (1 - gamma));
  step.begin = alpha_f;
  step.end = now_f;
  step.history.topLeftCorner<3, 3>() << 1, 0, 0,       //
      0, 1 - gamma / beta, 1 - gamma - gamma * share,  //
      0, -1 / beta, -share;
  step.change.head<3>() << 1, gamma / beta, 1 / beta;
  return step;
}

/// The same, linearly implicit. A member's z'' is that at (α_m − α_f) Δt past the end of its step, so that δ − δ* =
/// β Δt³ d³z/dt³ and the local error of z is (β − 1/6 + (α_m − α_f)/2) Δt³ d³z/dt³; for Newmark's method see
/// [ZX91].
ImplicitStep<> linearised(const NewmarkFamily& method) {
  auto step = member(method);
  step.guess.head<3>() << 0, 1, 0.5;
  step.trust = 0.25;
  step.error = (method.beta - 1. / 6 + (method.alpha_m - method.alpha_f) / 2) / method.beta;
  return step;
}

/// δ = Δt z' + Δt² z''/2, then z''_{n+1} from the equation of motion with z'_{n+1} = z' + Δt (z'' + z''_{n+1}) / 2.
ExplicitStep<> half_steps() {
  ExplicitStep<> step{.drag = 0.5, .stable = 2};
  step.displacement.head<3>() << 0, 1, 0.5;
  step.velocity.head<3>() << 0, 1, 0.5;
  step.history.topLeftCorner<2, 3>() << 1, 1, 0.5,  //
      0, 1, 0.5;
  step.change.head<3>() << 0, 0.5, 1;
  return step;
}

/// z'_{n+1} = δ / Δt,  (z'_{n+1} − z'_n) / Δt + D z'_{n+1} + f̃(z_{n+1}) = f_{n+1}.
ImplicitStep<> first_order() {
  ImplicitStep<> step{.inertia = 1, .drag = 1};
  step.acceleration[1] = 1;
  step.history(0, 0) = 1;
  step.change.head<2>() << 1, 1;
  return step;
}

/// The same, which keeps what the next step needs.
ImplicitStep<> first_of_two() {
  ImplicitStep<> step = first_order();
  step.history(3, 1) = 1;
  step.change[2] = 1;
  return step;
}

/// With δ_n = z_n − z_{n−1}: z'_{n+1} = (3 δ − δ_n) / 2Δt,  (3 z'_{n+1} − 4 z'_n + z'_{n−1}) / 2Δt + D z'_{n+1} + f̃ =
/// f_{n+1}.
ImplicitStep<> second_order() {
  ImplicitStep<> step{.inertia = 2.25, .drag = 1.5};
  step.acceleration << 0, 2, 0.75, -0.5;
  step.velocity[2] = 0.5;
  step.history(0, 0) = step.history(3, 1) = 1;
  step.history(1, 2) = -0.5;
  step.change.head<3>() << 1, 1.5, 1;
  return step;
}

/// δ / Δt = (z'_n + z'_{n+1}) / 2,  (z'_{n+1} − z'_n) / Δt + D δ / Δt + ∫₀¹ f̃(z_n + s δ) ds = (f_n + f_{n+1}) / 2.
/// Multiplied by δ: the kinetic energy changes by the loads' work less the damping's less the change of Ẽ, whatever Δt
/// is.
ImplicitStep<> average_vector_field() {
  ImplicitStep<> step{.inertia = 2, .drag = 1, .rule = ForceRule::mean_of_step, .point = 0.5};
  step.acceleration[1] = 2;
  step.begin = step.end = 0.5;
  step.history(0, 0) = 1;
  step.history(1, 1) = -1;
  step.change.head<2>() << 1, 2;
  return step;
}

}  // namespace

Integrator newmark() { return {"newmark", History::acceleration, member(average_acceleration)}; }

Integrator generalized_alpha() { return {"generalized-alpha", History::acceleration, member(chung_hulbert(0.8))}; }

Integrator linearly_implicit() { return {"linearly-implicit", History::acceleration, linearised(chung_hulbert(0.8))}; }

Integrator central_difference() { return {"central-difference", History::acceleration, half_steps()}; }

Integrator implicit_euler() { return {"implicit-euler", History::none, first_order()}; }

Integrator bdf2() { return {"bdf2", History::last_step, second_order(), first_of_two()}; }

Integrator avf() { return {"avf", History::none, average_vector_field()}; }

void refuse_unstable(const Integrator& integrator, double omega, double dt) {
  const auto* method = std::get_if<ExplicitStep<>>(&integrator.step);
  if (!method || omega * dt <= method->stable * (1 + 16 * std::numeric_limits<double>::epsilon())) return;
  throw InputError(std::string(integrator.name) + " with a step of " + shown(dt) + " s is unstable for the mode of " +
                   shown(omega / (2 * M_PI)) + " Hz: choose a step of at most " +
                   shown((1 - 6e-6) * method->stable / omega) + " s or another integrator");
}

}  // namespace ritz::runtime
