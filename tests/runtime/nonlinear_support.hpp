// All integrators of nonlinear models, and runs of them.
#pragma once
#include <vector>

#include "ritz/runtime/step.hpp"
#include "support/sample_polynomial.hpp"

namespace ritz::test {

inline std::vector<runtime::Integrator> implicit_methods() {
  using namespace runtime;
  return {implicit_euler(), newmark(), generalized_alpha(), bdf2(), avf(), linearly_implicit()};
}

inline std::vector<runtime::Integrator> all_methods() {
  auto methods = implicit_methods();
  methods.push_back(runtime::central_difference());
  return methods;
}

/// A model, an integrator, a state: steps under a constant force.
template <class Scalar>
struct Motion {
  runtime::Model<Scalar> model;
  runtime::State<Scalar> state;
  runtime::Workspace<Scalar> workspace;
  runtime::Vector<Scalar> force;
  Scalar dt;
  runtime::Evaluation<Scalar> room;

  runtime::Outcome step() { return runtime::step<Scalar>(model, state, {force, force}, dt, workspace); }
  Scalar energy() { return runtime::energy(model, state, room); }
};

/// From z at rest.
template <class Scalar>
Motion<Scalar> start(runtime::Model<Scalar> model, const runtime::Integrator& integrator, double dt,
                     const Eigen::VectorXd& z, double force = 0, const runtime::NewtonOptions<Scalar>& options = {},
                     runtime::Loads loads = runtime::Loads::of_time) {
  using runtime::Vector;
  const Vector<Scalar> rest = Vector<Scalar>::Zero(model.size());
  const Vector<Scalar> load = Vector<Scalar>::Constant(model.size(), Scalar(force));
  auto state = runtime::make_state<Scalar>(model, integrator, z.cast<Scalar>(), rest, load);
  auto workspace = runtime::make_workspace<Scalar>(model, integrator, Scalar(dt), options, loads);
  auto room = runtime::make_evaluation(model.force);
  return {std::move(model), std::move(state), std::move(workspace), load, Scalar(dt), std::move(room)};
}

template <class Scalar = double>
Motion<Scalar> start(const model::Polynomial& polynomial, const runtime::Integrator& integrator, double dt,
                     const Eigen::VectorXd& z, double force = 0, const runtime::Damping& damping = {},
                     const runtime::NewtonOptions<Scalar>& options = {}) {
  return start<Scalar>(runtime::make_model<Scalar>(polynomial, damping), integrator, dt, z, force, options);
}

}  // namespace ritz::test
