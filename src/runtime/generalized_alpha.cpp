#include "newmark_family.hpp"
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

/// The optimal member of given damping ρ∞ of the highest frequencies, [CH93] Eqs. 17, 18, 25.
constexpr NewmarkFamily chung_hulbert(double rho) {
  const double alpha_m = (2 * rho - 1) / (rho + 1), alpha_f = rho / (rho + 1);
  const double surplus = 1 - alpha_m + alpha_f;
  return {.beta = surplus * surplus / 4, .gamma = surplus - 0.5, .alpha_m = alpha_m, .alpha_f = alpha_f};
}

ModeStep rule(double stiffness, double damping, double dt) {
  return family_step(chung_hulbert(0.8), stiffness, damping, dt);
}

}  // namespace

Integrator generalized_alpha() { return {"generalized-alpha", History::acceleration, rule, rule}; }

}  // namespace ritz::runtime
