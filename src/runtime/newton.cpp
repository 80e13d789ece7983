#include "newton.hpp"

#include <cmath>

namespace ritz::runtime {
namespace {

/// How often a correction that enlarges the residual is halved.
constexpr int shortenings = 5;

template <class Scalar>
bool takes_mean(const NonlinearWorkspace<Scalar>& workspace) {
  return workspace.method.rule == ForceRule::mean_of_step;
}

/// Evaluates F and F' at δ, leaves R in workspace.residual and returns what ‖R‖ is measured by.
template <class Scalar>
Scalar evaluate_residual(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                         NonlinearWorkspace<Scalar>& workspace) {
  const auto& equation = workspace.equation;
  if (takes_mean(workspace)) {
    evaluate_mean<Scalar>(model.forces, state.z(), workspace.delta, workspace.mean);
  } else {
    workspace.point = state.z() + equation.point * workspace.delta;
    evaluate<Scalar>(model.forces, workspace.point, workspace.at_point);
  }
  const auto& force = takes_mean(workspace) ? workspace.mean.force : workspace.at_point.force;
  workspace.residual = equation.inertia * workspace.delta + equation.share * force - equation.target;
  workspace.residual.noalias() += equation.drag * model.damping * workspace.delta;
  return equation.inertia * workspace.delta.norm() + equation.share * force.norm() + equation.target.norm();
}

/// The Jacobian of R where evaluate_residual was last.
template <class Scalar>
void assemble_jacobian(const NonlinearModel<Scalar>& model, NonlinearWorkspace<Scalar>& workspace) {
  const auto& equation = workspace.equation;
  const auto& tangent = takes_mean(workspace) ? workspace.mean.tangent : workspace.at_point.tangent;
  const Scalar share = takes_mean(workspace) ? equation.share : equation.share * equation.point;
  workspace.jacobian = share * tangent + equation.drag * model.damping;
  workspace.jacobian.diagonal().array() += equation.inertia;
}

/// δ −= (the factored matrix)⁻¹ R; returns the length of the change.
template <class Scalar>
Scalar correct(NonlinearWorkspace<Scalar>& workspace) {
  workspace.correction = workspace.residual;
  solve_in_place(workspace.factors, workspace.correction);
  workspace.delta -= workspace.correction;
  return workspace.correction.norm();
}

}  // namespace

template <class Scalar>
void linearise(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state, const Vector<Scalar>& delta,
               NonlinearWorkspace<Scalar>& workspace) {
  workspace.delta = delta;
  evaluate_residual(model, state, workspace);
  assemble_jacobian(model, workspace);
}

template <class Scalar>
NonlinearOutcome newton(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                        NonlinearWorkspace<Scalar>& workspace) {
  constexpr Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon();
  NonlinearOutcome outcome{.status = Status::not_converged};
  workspace.delta.setZero();
  Scalar last = std::numeric_limits<Scalar>::infinity();
  int shortened = 0;
  for (;;) {
    const Scalar scale = evaluate_residual(model, state, workspace);
    ++outcome.evaluations;
    const Scalar size = workspace.residual.norm();
    if (!std::isfinite(size)) {
      outcome.status = Status::not_finite;
      return outcome;
    }
    const bool started = outcome.iterations > 0;
    if (size == 0 || (started && size <= workspace.options.tolerance * scale)) break;
    if (size > last && shortened < shortenings) {  // the correction went too far: take half of it back
      workspace.correction /= 2;
      workspace.delta += workspace.correction;
      ++shortened;
      continue;
    }
    if (outcome.iterations == workspace.options.iterations) return outcome;
    last = size;
    shortened = 0;
    assemble_jacobian(model, workspace);
    factor(workspace.jacobian, workspace.factors);
    const Scalar change = correct(workspace);
    ++outcome.iterations;
    if (change <= rounding * (state.z().norm() + workspace.delta.norm())) {
      outcome.status = Status::done;  // δ is as good as its last digit, whatever R's rounding
      return outcome;
    }
  }
  // The last factors are at hand: one more correction by them costs next to nothing and makes a small residual tiny.
  if (outcome.iterations > 0) correct(workspace);
  outcome.status = workspace.delta.allFinite() ? Status::done : Status::not_finite;
  return outcome;
}

template <class Scalar>
NonlinearOutcome explicit_acceleration(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                                       VectorRef<Scalar> load, Scalar dt, NonlinearWorkspace<Scalar>& workspace) {
  if (workspace.factored_dt != dt) {
    workspace.jacobian = (dt / 2) * model.damping;
    workspace.jacobian.diagonal().array() += 1;
    factor(workspace.jacobian, workspace.factors);
    workspace.factored_dt = dt;
  }
  workspace.point = state.z() + workspace.equation.target;
  evaluate<Scalar>(model.forces, workspace.point, workspace.at_point);
  workspace.residual = state.history.col(1) + (dt / 2) * state.history.col(2);
  workspace.delta = load - workspace.at_point.force;
  workspace.delta.noalias() -= model.damping * workspace.residual;
  solve_in_place(workspace.factors, workspace.delta);
  return {.status = workspace.delta.allFinite() ? Status::done : Status::not_finite, .evaluations = 1};
}

#define RITZ_INSTANCE(S)                                                                                               \
  template void linearise(const NonlinearModel<S>&, const NonlinearState<S>&, const Vector<S>&,                        \
                          NonlinearWorkspace<S>&);                                                                     \
  template NonlinearOutcome newton(const NonlinearModel<S>&, const NonlinearState<S>&, NonlinearWorkspace<S>&);        \
  template NonlinearOutcome explicit_acceleration(const NonlinearModel<S>&, const NonlinearState<S>&, VectorRef<S>, S, \
                                                  NonlinearWorkspace<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
