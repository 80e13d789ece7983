#include "newmark_family.hpp"
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

ModeStep rule(double stiffness, double damping, double dt) {
  return family_step(average_acceleration, stiffness, damping, dt);
}

}  // namespace

Integrator newmark() { return {"newmark", History::acceleration, rule, rule}; }

}  // namespace ritz::runtime
