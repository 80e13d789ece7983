// The generalized-α family, which contains Newmark's methods and central differences.
#pragma once
#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {

/// m(z'') + d m'(z') + λ m'(z) = m'(f), with m(x) = (1 - α_m) x_{n+1} + α_m x_n and m' likewise with α_f;
/// z_{n+1} = z + Δt z' + Δt² [(½ - β) z'' + β z''_{n+1}],  z'_{n+1} = z' + Δt [(1 - γ) z'' + γ z''_{n+1}].
struct NewmarkFamily {
  double beta, gamma;
  double alpha_m = 0, alpha_f = 0;
};

/// Newmark's method of average acceleration.
inline constexpr NewmarkFamily average_acceleration{.beta = 0.25, .gamma = 0.5};

/// The optimal member of given damping ρ∞ of the highest frequencies, [CH93] Eqs. 17, 18, 25.
constexpr NewmarkFamily chung_hulbert(double rho) {
  const double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
  const double surplus = 1 - alpha_m + alpha_f;
  return {.beta = surplus * surplus / 4, .gamma = surplus - 0.5, .alpha_m = alpha_m, .alpha_f = alpha_f};
}

/// One step of y = [z, z', z''].
ModeStep family_step(const NewmarkFamily& method, double stiffness, double damping, double dt);

}  // namespace ritz::runtime
