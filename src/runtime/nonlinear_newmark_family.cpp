// The generalised-α family over the change δ of a step; Newmark's method is α_m = α_f = 0.
//   z''_{n+1} = (δ − Δt z' − (½ − β) Δt² z'') / βΔt²,  z'_{n+1} = z' + Δt ((1 − γ) z'' + γ z''_{n+1}),
//   mix(α_m; z'') + D mix(α_f; z') + f̃(mix(α_f; z)) = mix(α_f; f),  mix(α; x) = α x_n + (1 − α) x_{n+1}.
#include "newmark_family.hpp"
#include "ritz/runtime/method.hpp"

namespace ritz::runtime {
namespace {

template <NewmarkFamily method, class Scalar>
void equation(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
              const NonlinearLoad<Scalar>& load, Scalar dt, StepEquation<Scalar>& equation) {
  const auto beta = Scalar(method.beta), gamma = Scalar(method.gamma), alpha_f = Scalar(method.alpha_f);
  const Scalar now_m = 1 - Scalar(method.alpha_m), now_f = 1 - alpha_f;
  const auto velocity = state.history.col(1), acceleration = state.history.col(2);
  equation.inertia = now_m / (beta * dt * dt);
  equation.drag = now_f * gamma / (beta * dt);
  equation.share = 1;
  equation.point = now_f;
  const Scalar by_velocity = now_m / (beta * dt), by_acceleration = now_m * (Scalar(0.5) - beta) / beta;
  equation.target = alpha_f * load.begin + now_f * load.end + by_velocity * velocity +
                    (by_acceleration - Scalar(method.alpha_m)) * acceleration;
  const Scalar drag_velocity = now_f * gamma / beta - 1;  // the damping's part of mix(α_f; z') that δ does not decide
  const Scalar drag_acceleration = now_f * dt * (gamma * (Scalar(0.5) - beta) / beta - (1 - gamma));
  equation.scratch = drag_velocity * velocity + drag_acceleration * acceleration;
  equation.target.noalias() += model.damping * equation.scratch;
}

template <NewmarkFamily method, class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  const auto beta = Scalar(method.beta), gamma = Scalar(method.gamma);
  auto& history = state.history;
  for (Eigen::Index i = 0; i < delta.size(); ++i) {
    const Scalar velocity = history(i, 1), acceleration = history(i, 2);
    const Scalar next = (delta[i] - dt * velocity - (Scalar(0.5) - beta) * dt * dt * acceleration) / (beta * dt * dt);
    history(i, 0) += delta[i];
    history(i, 1) = velocity + dt * ((1 - gamma) * acceleration + gamma * next);
    history(i, 2) = next;
  }
}

template <NewmarkFamily method, class Scalar>
Method<Scalar> member(std::string_view name) {
  return {name, History::acceleration, ForceRule::at_point, equation<method, Scalar>, advance<method, Scalar>};
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_newmark() {
  return member<average_acceleration, Scalar>("newmark");
}

template <class Scalar>
Method<Scalar> nonlinear_generalized_alpha() {
  return member<chung_hulbert(0.8), Scalar>("generalized-alpha");
}

template Method<double> nonlinear_newmark();
template Method<float> nonlinear_newmark();
template Method<double> nonlinear_generalized_alpha();
template Method<float> nonlinear_generalized_alpha();

}  // namespace ritz::runtime
