// z'_{n+1} = (3 z_{n+1} − 4 z_n + z_{n−1}) / 2Δt,  (3 z'_{n+1} − 4 z'_n + z'_{n−1}) / 2Δt + D z'_{n+1} + f̃ = f_{n+1}.
// History: z, z', z and z' of the step before. Where that had another length (or there was none), implicit Euler.
#include "ritz/runtime/method.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
void equation(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
              const NonlinearLoad<Scalar>& load, Scalar dt, StepEquation<Scalar>& equation) {
  const auto z = state.history.col(0), velocity = state.history.col(1);
  const auto z_before = state.history.col(2), velocity_before = state.history.col(3);
  equation.share = equation.point = 1;
  if (state.last_dt != dt) {
    equation.inertia = 1 / (dt * dt);
    equation.drag = 1 / dt;
    equation.target = load.end + velocity / dt;
    return;
  }
  equation.inertia = Scalar(2.25) / (dt * dt);
  equation.drag = Scalar(1.5) / dt;
  // z'_{n+1} = (3 δ − (z_n − z_{n−1})) / 2Δt
  equation.target =
      load.end + (4 * velocity - velocity_before) / (2 * dt) + (z - z_before) * (Scalar(0.75) / (dt * dt));
  equation.scratch = (z - z_before) / (2 * dt);
  equation.target.noalias() += model.damping * equation.scratch;
}

template <class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  auto& history = state.history;
  for (Eigen::Index i = 0; i < delta.size(); ++i) {
    const Scalar z = history(i, 0), velocity = history(i, 1);
    history(i, 0) = z + delta[i];
    history(i, 1) = state.last_dt == dt ? (3 * delta[i] - (z - history(i, 2))) / (2 * dt) : delta[i] / dt;
    history(i, 2) = z;
    history(i, 3) = velocity;
  }
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_bdf2() {
  return {"bdf2", History::last_step, ForceRule::at_point, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_bdf2();
template Method<float> nonlinear_bdf2();

}  // namespace ritz::runtime
