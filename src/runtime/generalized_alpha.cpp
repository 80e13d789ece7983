#include "newmark_family.hpp"
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

ModeStep rule(double stiffness, double damping, double dt) {
  return family_step(chung_hulbert(0.8), stiffness, damping, dt);
}

}  // namespace

Integrator generalized_alpha() { return {"generalized-alpha", History::acceleration, rule, rule}; }

}  // namespace ritz::runtime
