// z_{n+1} = ẑ + h z'_{n+1},  z'_{n+1} = ẑ' + h (f_{n+1} - d z'_{n+1} - λ z_{n+1}),
// with ẑ = (4 z_n - z_{n-1}) / 3 and h = 2Δt / 3. The first step has no z_{n-1}: it is one of implicit Euler.
#include "ritz/runtime/integrators.hpp"

namespace ritz::runtime {
namespace {

/// `current` and `last`: the weights of steps n and n-1 in ẑ.
ModeStep backward_difference(double stiffness, double damping, double h, double current, double last) {
  const double pivot = 1 + h * (damping + h * stiffness);
  Eigen::Matrix2d solve;
  solve << (1 + h * damping) / pivot, h / pivot, -h * stiffness / pivot, 1 / pivot;
  ModeStep step;
  step.A.topLeftCorner<2, 2>() = current * solve;
  step.A.topRightCorner<2, 2>() = last * solve;
  step.A.bottomLeftCorner<2, 2>().setIdentity();
  step.c.head<2>() << h * h / pivot, h / pivot;
  return step;
}

ModeStep rule(double stiffness, double damping, double dt) {
  return backward_difference(stiffness, damping, 2 * dt / 3, 4. / 3, -1. / 3);
}

ModeStep first(double stiffness, double damping, double dt) {
  return backward_difference(stiffness, damping, dt, 1, 0);
}

}  // namespace

Integrator bdf2() { return {"bdf2", History::last_step, rule, first}; }

}  // namespace ritz::runtime
