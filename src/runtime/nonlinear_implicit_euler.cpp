// z'_{n+1} = δ / Δt,  (z'_{n+1} − z'_n) / Δt + D z'_{n+1} + f̃(z_{n+1}) = f_{n+1}.
#include "ritz/runtime/method.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
void equation(const NonlinearModel<Scalar>&, const NonlinearState<Scalar>& state, const NonlinearLoad<Scalar>& load,
              Scalar dt, StepEquation<Scalar>& equation) {
  equation.inertia = 1 / (dt * dt);
  equation.drag = 1 / dt;
  equation.share = equation.point = 1;
  equation.target = load.end + state.velocity() / dt;
}

template <class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  state.history.col(0) += delta;
  state.history.col(1) = delta / dt;
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_implicit_euler() {
  return {"implicit-euler", History::none, ForceRule::at_point, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_implicit_euler();
template Method<float> nonlinear_implicit_euler();

}  // namespace ritz::runtime
