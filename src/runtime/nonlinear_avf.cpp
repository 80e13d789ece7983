// δ / Δt = (z'_n + z'_{n+1}) / 2,  (z'_{n+1} − z'_n) / Δt + D δ / Δt + ∫₀¹ f̃(z_n + s δ) ds = (f_n + f_{n+1}) / 2.
// Times δ: the kinetic energy changes by the loads' work less the damping's less the change of Ẽ, whatever Δt is.
#include "ritz/runtime/method.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
void equation(const NonlinearModel<Scalar>&, const NonlinearState<Scalar>& state, const NonlinearLoad<Scalar>& load,
              Scalar dt, StepEquation<Scalar>& equation) {
  equation.inertia = 2 / (dt * dt);
  equation.drag = 1 / dt;
  equation.share = equation.point = 1;
  equation.target = (load.begin + load.end) / 2 + state.velocity() * (2 / dt);
}

template <class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  state.history.col(0) += delta;
  state.history.col(1) = delta * (2 / dt) - state.history.col(1);
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_avf() {
  return {"avf", History::none, ForceRule::mean_of_step, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_avf();
template Method<float> nonlinear_avf();

}  // namespace ritz::runtime
