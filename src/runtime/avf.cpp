// δ / Δt = (z'_n + z'_{n+1}) / 2,  (z'_{n+1} − z'_n) / Δt + D δ / Δt + ∫₀¹ f̃(z_n + s δ) ds = (f_n + f_{n+1}) / 2.
// Times δ: the kinetic energy changes by the loads' work less the damping's less the change of Ẽ, whatever Δt is.
#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {
namespace {

ImplicitStep<> average_vector_field() {
  ImplicitStep<> step{.inertia = 2, .drag = 1, .rule = ForceRule::mean_of_step, .point = 0.5};
  step.acceleration[1] = 2;
  step.begin = step.end = 0.5;
  step.history(0, 0) = 1;
  step.history(1, 1) = -1;
  step.change.head<2>() << 1, 2;
  return step;
}

}  // namespace

Integrator avf() { return {"avf", History::none, average_vector_field()}; }

}  // namespace ritz::runtime
