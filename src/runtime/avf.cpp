// The mean force along the step is, for a linear force, the force at the midpoint:
// (z'_{n+1} - z'_n) / Δt + d m(z') + λ m(z) = m(f),  (z_{n+1} - z_n) / Δt = m(z'),  m the mean of n and n+1.
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

ModeStep rule(double stiffness, double damping, double dt) {
  const double d = dt * damping / 2, k = dt * dt * stiffness / 4, pivot = 1 + d + k;
  ModeStep step;
  step.A.topLeftCorner<2, 2>() << (1 + d - k) / pivot, dt / pivot, -dt * stiffness / pivot, (1 - d - k) / pivot;
  step.b.head<2>() << dt * dt / (4 * pivot), dt / (2 * pivot);
  step.c = step.b;
  return step;
}

}  // namespace

Integrator avf() { return {"avf", History::none, rule, rule}; }

}  // namespace ritz::runtime
