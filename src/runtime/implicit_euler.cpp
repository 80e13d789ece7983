// z_{n+1} = z_n + Δt z'_{n+1},  z'_{n+1} = z'_n + Δt (f_{n+1} - d z'_{n+1} - λ z_{n+1}).
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

ModeStep rule(double stiffness, double damping, double dt) {
  const double pivot = 1 + dt * (damping + dt * stiffness);
  ModeStep step;
  step.A.topLeftCorner<2, 2>() << (1 + dt * damping) / pivot, dt / pivot, -dt * stiffness / pivot, 1 / pivot;
  step.c.head<2>() << dt * dt / pivot, dt / pivot;
  return step;
}

}  // namespace

Integrator implicit_euler() { return {"implicit-euler", History::none, rule, rule}; }

}  // namespace ritz::runtime
