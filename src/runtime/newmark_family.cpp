// The generalised-α family over the change δ of a step; Newmark's method is α_m = α_f = 0.
//   z''_{n+1} = (δ − Δt z' − (½ − β) Δt² z'') / βΔt²,  z'_{n+1} = z' + Δt ((1 − γ) z'' + γ z''_{n+1}),
//   mix(α_m; z'') + D mix(α_f; z') + f̃(mix(α_f; z)) = mix(α_f; f),  mix(α; x) = α x_n + (1 − α) x_{n+1}.
// With β = 0, γ = ½ it is the central difference with velocities at whole steps, which is explicit.
#include "ritz/runtime/integrator.hpp"

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

}  // namespace

Integrator newmark() { return {"newmark", History::acceleration, member(average_acceleration)}; }

Integrator generalized_alpha() { return {"generalized-alpha", History::acceleration, member(chung_hulbert(0.8))}; }

Integrator central_difference() { return {"central-difference", History::acceleration, half_steps()}; }

}  // namespace ritz::runtime
