#include "ritz/runtime/step.hpp"

namespace ritz::runtime {
namespace {

/// A rule that bounds the step refuses it; the bound that holds for all modes is the stiffest one's.
void refuse_unstable(const Oscillators& model, StepRule rule, double dt) {
  if (model.size() == 0) return;
  Eigen::Index stiffest = 0;
  model.stiffness.maxCoeff(&stiffest);
  rule(model.stiffness[stiffest], model.damping[stiffest], dt);
}

void tabulate(const Oscillators& model, StepRule rule, double dt, int width, Eigen::ArrayXXd& table) {
  refuse_unstable(model, rule, dt);
  for (Eigen::Index mode = 0; mode < model.size(); ++mode) {
    const ModeStep coefficients = rule(model.stiffness[mode], model.damping[mode], dt);
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < width; ++j) table(mode, i * width + j) = coefficients.A(i, j);
      table(mode, width * width + i) = coefficients.b[i];
      table(mode, width * (width + 1) + i) = coefficients.c[i];
    }
  }
}

void prepare(const Oscillators& model, double dt, Workspace& workspace) {
  const Integrator& integrator = workspace.integrator;
  const int width = history_size(integrator.history);
  tabulate(model, integrator.step, dt, width, workspace.step);
  if (integrator.start != integrator.step) tabulate(model, integrator.start, dt, width, workspace.start);
  workspace.dt = dt;
}

}  // namespace

Workspace make_workspace(const Oscillators& model, const Integrator& integrator, double dt) {
  const int width = history_size(integrator.history);
  Workspace workspace{.integrator = integrator};
  workspace.step.resize(model.size(), width * (width + 2));
  if (integrator.start != integrator.step) workspace.start.resize(model.size(), width * (width + 2));
  workspace.next.resize(model.size(), width);
  prepare(model, dt, workspace);
  return workspace;
}

State make_state(const Oscillators& model, const Integrator& integrator, Eigen::Ref<const Eigen::VectorXd> z,
                 Eigen::Ref<const Eigen::VectorXd> velocity, Eigen::Ref<const Eigen::VectorXd> load) {
  State state;
  state.history.setZero(model.size(), history_size(integrator.history));
  state.history.col(0) = z;
  state.history.col(1) = velocity;
  if (integrator.history == History::acceleration)
    state.history.col(2) = load.array() - model.damping * velocity.array() - model.stiffness * z.array();
  return state;
}

Outcome step(const Oscillators& model, State& state, const StepLoad& load, double dt, Workspace& workspace) {
  if (dt != workspace.dt) prepare(model, dt, workspace);
  const bool starts = workspace.integrator.start != workspace.integrator.step && state.last_dt != dt;
  const Eigen::ArrayXXd& table = starts ? workspace.start : workspace.step;
  const Eigen::Index width = workspace.next.cols();
  for (Eigen::Index i = 0; i < width; ++i) {
    auto next = workspace.next.col(i).array();
    next = table.col(width * width + i) * load.begin.array() + table.col(width * (width + 1) + i) * load.end.array();
    for (Eigen::Index j = 0; j < width; ++j) next += table.col(i * width + j) * state.history.col(j).array();
  }
  if (!workspace.next.allFinite()) return {Status::not_finite};
  state.history.swap(workspace.next);
  state.last_dt = dt;
  return {};
}

}  // namespace ritz::runtime
