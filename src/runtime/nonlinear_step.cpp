#include "ritz/runtime/nonlinear_step.hpp"

#include <cmath>
#include <string>

#include "eigenvalues.hpp"
#include "newton.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
void refuse_unstable(Scalar dt, Scalar longest) {
  if (dt > longest * (1 + 16 * std::numeric_limits<Scalar>::epsilon()))
    throw InputError("central-difference with a step of " + shown(dt) +
                     " s is unstable already for small motions: choose a step of at most " +
                     shown((1 - 6e-6) * longest) + " s or another integrator");
}

/// 2/ω_max of the model at rest, s.
template <class Scalar>
Scalar longest_stable(const NonlinearModel<Scalar>& model) {
  const double largest = eigenvalues(model.forces.linear.template cast<double>()).maxCoeff();
  return largest > 0 ? static_cast<Scalar>(2 / std::sqrt(largest)) : std::numeric_limits<Scalar>::infinity();
}

/// One attempt at a part of a step; advances the state where it succeeds.
template <class Scalar>
NonlinearOutcome attempt(const NonlinearModel<Scalar>& model, NonlinearState<Scalar>& state,
                         const NonlinearLoad<Scalar>& load, Scalar dt, NonlinearWorkspace<Scalar>& workspace) {
  const auto& method = workspace.method;
  method.equation(model, state, load, dt, workspace.equation);
  const auto outcome = method.rule == ForceRule::explicit_step
                           ? explicit_acceleration(model, state, load.end, dt, workspace)
                           : newton(model, state, workspace);
  if (outcome.status != Status::done) return outcome;
  method.advance(workspace.delta, dt, state);
  state.last_dt = dt;
  return outcome;
}

}  // namespace

template <class Scalar>
NonlinearWorkspace<Scalar> make_workspace(const NonlinearModel<Scalar>& model, const Method<Scalar>& method, Scalar dt,
                                          const NewtonOptions<Scalar>& options) {
  if (!(dt > 0)) throw InputError("a step of " + shown(dt) + " s is not positive");
  const Eigen::Index r = model.size();
  const Vector<Scalar> none = Vector<Scalar>::Zero(r);
  NonlinearWorkspace<Scalar> workspace{.method = method,
                                       .options = options,
                                       .at_point = make_evaluation(model.forces),
                                       .mean = make_mean_evaluation(model.forces),
                                       .equation = {.target = none, .scratch = none},
                                       .jacobian = Matrix<Scalar>::Zero(r, r),
                                       .factors = make_factors<Scalar>(r),
                                       .delta = none,
                                       .point = none,
                                       .residual = none,
                                       .correction = none,
                                       .begin = none,
                                       .end = none,
                                       .from = none,
                                       .before = {Matrix<Scalar>::Zero(r, history_size(method.history)), 0}};
  if (method.rule == ForceRule::explicit_step) workspace.stable_dt = longest_stable(model);
  refuse_unstable(dt, workspace.stable_dt);
  return workspace;
}

template <class Scalar>
NonlinearOutcome step(const NonlinearModel<Scalar>& model, NonlinearState<Scalar>& state,
                      const NonlinearLoad<Scalar>& load, Scalar dt, NonlinearWorkspace<Scalar>& workspace) {
  refuse_unstable(dt, workspace.stable_dt);
  const auto narrowest = std::ldexp(Scalar(1), -workspace.options.halvings);
  NonlinearOutcome outcome;
  workspace.before = state;
  Scalar at = 0, width = 1;  // fractions of the step, exact in binary
  while (at < 1) {
    workspace.begin = (1 - at) * load.begin + at * load.end;
    workspace.end = (1 - at - width) * load.begin + (at + width) * load.end;
    workspace.from = state.z();
    const auto part = attempt<Scalar>(model, state, {workspace.begin, workspace.end}, width * dt, workspace);
    outcome.iterations += part.iterations;
    outcome.evaluations += part.evaluations;
    outcome.status = state.history.allFinite() ? part.status : Status::not_finite;
    if (outcome.status == Status::done) {
      workspace.delta = state.z() - workspace.from;
      workspace.residual.noalias() = model.damping * workspace.delta;
      outcome.work += static_cast<double>((workspace.begin + workspace.end).dot(workspace.delta)) / 2;
      outcome.dissipated += static_cast<double>(workspace.residual.dot(workspace.delta) / (width * dt));
      at += width;
      if (width < 1 && std::fmod(at, 2 * width) == 0) width *= 2;
      continue;
    }
    ++outcome.rejected;
    width /= 2;
    if (part.status != Status::done && width >= narrowest) continue;
    state = workspace.before;
    return outcome;
  }
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                                   \
  template NonlinearWorkspace<S> make_workspace(const NonlinearModel<S>&, const Method<S>&, S,             \
                                                const NewtonOptions<S>&);                                  \
  template NonlinearOutcome step(const NonlinearModel<S>&, NonlinearState<S>&, const NonlinearLoad<S>&, S, \
                                 NonlinearWorkspace<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
