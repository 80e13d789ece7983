#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {
namespace {

/// z'_{n+1} = δ / Δt,  (z'_{n+1} − z'_n) / Δt + D z'_{n+1} + f̃(z_{n+1}) = f_{n+1}.
ImplicitStep<> first_order() {
  ImplicitStep<> step{.inertia = 1, .drag = 1};
  step.acceleration[1] = 1;
  step.history(0, 0) = 1;
  step.change.head<2>() << 1, 1;
  return step;
}

/// The same, which keeps what the next step needs.
ImplicitStep<> first_of_two() {
  ImplicitStep<> step = first_order();
  step.history(3, 1) = 1;
  step.change[2] = 1;
  return step;
}

/// With δ_n = z_n − z_{n−1}: z'_{n+1} = (3 δ − δ_n) / 2Δt,  (3 z'_{n+1} − 4 z'_n + z'_{n−1}) / 2Δt + D z'_{n+1} + f̃ =
/// f_{n+1}.
ImplicitStep<> second_order() {
  ImplicitStep<> step{.inertia = 2.25, .drag = 1.5};
  step.acceleration << 0, 2, 0.75, -0.5;
  step.velocity[2] = 0.5;
  step.history(0, 0) = step.history(3, 1) = 1;
  step.history(1, 2) = -0.5;
  step.change.head<3>() << 1, 1.5, 1;
  return step;
}

}  // namespace

Integrator implicit_euler() { return {"implicit-euler", History::none, first_order()}; }

Integrator bdf2() { return {"bdf2", History::last_step, second_order(), first_of_two()}; }

}  // namespace ritz::runtime
