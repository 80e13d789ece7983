// Newmark's method with β = 0, γ = ½ is the central difference with velocities at whole steps.
#include <cmath>

#include "newmark_family.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

ModeStep rule(double stiffness, double damping, double dt) {
  const double omega = std::sqrt(stiffness);
  if (omega * dt > 2)
    throw InputError("central-difference with a step of " + shown(dt) + " s is unstable for the mode of " +
                     shown(omega / (2 * M_PI)) + " Hz: choose a step of at most " + shown((1 - 6e-6) * 2 / omega) +
                     " s or another integrator");
  return family_step({.beta = 0, .gamma = 0.5}, stiffness, damping, dt);
}

}  // namespace

Integrator central_difference() { return {"central-difference", History::acceleration, rule, rule}; }

}  // namespace ritz::runtime
