// Stepping a linear model through time.
#pragma once
#include <Eigen/Core>

#include "ritz/runtime/integrator.hpp"
#include "ritz/runtime/oscillators.hpp"

namespace ritz::runtime {

/// Everything the next step depends on: store it and go on later.
struct State {
  Eigen::MatrixXd history;  ///< r x history_size: columns z, z' (units of z per s), then the integrator's own
  double last_dt = 0;       ///< length of the step that led here, s; 0 at the start

  auto z() const { return history.col(0); }
  auto velocity() const { return history.col(1); }
};

/// The reduced force over a step, Uᵀf, linear between its ends; each of r numbers.
struct StepLoad {
  Eigen::Ref<const Eigen::VectorXd> begin;
  Eigen::Ref<const Eigen::VectorXd> end;
};

enum class Status : unsigned char {
  done,
  not_finite,    ///< the step was rejected, the state is as before
  not_converged  ///< the same, of a nonlinear model
};

struct Outcome {
  Status status = Status::done;
};

/// Coefficients of all modes for one length of step, and room for a step; one a thread.
struct Workspace {
  Integrator integrator;
  double dt = 0;
  Eigen::ArrayXXd step = {}, start = {};  ///< r x history (history + 2): columns A (row by row), then b, then c
  Eigen::MatrixXd next = {};              ///< r x history
};

/// Tabulates the coefficients for steps of `dt` > 0 seconds. Throws InputError where the integrator cannot take it.
Workspace make_workspace(const Oscillators& model, const Integrator& integrator, double dt);

/// The state with given z and z' under the force `load`; its acceleration is f - d z' - λ z.
State make_state(const Oscillators& model, const Integrator& integrator, Eigen::Ref<const Eigen::VectorXd> z,
                 Eigen::Ref<const Eigen::VectorXd> velocity, Eigen::Ref<const Eigen::VectorXd> load);

/// One step of `dt` seconds with the workspace's integrator. Does not allocate; O(r), and O(r) more work when `dt` is
/// not the length of the workspace's last step. Throws as make_workspace.
Outcome step(const Oscillators& model, State& state, const StepLoad& load, double dt, Workspace& workspace);

}  // namespace ritz::runtime
