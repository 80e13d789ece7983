// δ = Δt z' + Δt² z''/2, then z''_{n+1} from the equation of motion with z'_{n+1} = z' + Δt (z'' + z''_{n+1}) / 2.
#include "ritz/runtime/method.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
void equation(const NonlinearModel<Scalar>&, const NonlinearState<Scalar>& state, const NonlinearLoad<Scalar>&,
              Scalar dt, StepEquation<Scalar>& equation) {
  equation.target = dt * state.history.col(1) + (dt * dt / 2) * state.history.col(2);
}

template <class Scalar>
void advance(const Vector<Scalar>& acceleration, Scalar dt, NonlinearState<Scalar>& state) {
  auto& history = state.history;
  history.col(0) += dt * history.col(1) + (dt * dt / 2) * history.col(2);
  history.col(1) += (dt / 2) * (history.col(2) + acceleration);
  history.col(2) = acceleration;
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_central_difference() {
  return {"central-difference", History::acceleration, ForceRule::explicit_step, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_central_difference();
template Method<float> nonlinear_central_difference();

}  // namespace ritz::runtime
