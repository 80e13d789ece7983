#include "stable_step.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::runtime {

void refuse_unstable(const Integrator& integrator, double omega, double dt) {
  const auto* method = std::get_if<ExplicitStep<>>(&integrator.step);
  if (!method || omega * dt <= method->stable * (1 + 16 * std::numeric_limits<double>::epsilon())) return;
  throw InputError(std::string(integrator.name) + " with a step of " + shown(dt) + " s is unstable for the mode of " +
                   shown(omega / (2 * M_PI)) + " Hz: choose a step of at most " +
                   shown((1 - 6e-6) * method->stable / omega) + " s or another integrator");
}

}  // namespace ritz::runtime
