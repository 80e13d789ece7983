// All methods, and runs of them.
#pragma once
#include <vector>

#include "ritz/runtime/nonlinear_step.hpp"
#include "support/sample_polynomial.hpp"

namespace ritz::test {

template <class Scalar>
std::vector<runtime::Method<Scalar>> implicit_methods() {
  using namespace runtime;
  return {nonlinear_implicit_euler<Scalar>(), nonlinear_newmark<Scalar>(), nonlinear_generalized_alpha<Scalar>(),
          nonlinear_bdf2<Scalar>(), nonlinear_avf<Scalar>()};
}

template <class Scalar>
std::vector<runtime::Method<Scalar>> all_methods() {
  auto methods = implicit_methods<Scalar>();
  methods.push_back(runtime::nonlinear_central_difference<Scalar>());
  return methods;
}

/// A model, a method, a state: steps under a constant force.
template <class Scalar>
struct Motion {
  runtime::NonlinearModel<Scalar> model;
  runtime::NonlinearState<Scalar> state;
  runtime::NonlinearWorkspace<Scalar> workspace;
  runtime::Vector<Scalar> force;
  Scalar dt;

  runtime::NonlinearOutcome step() { return runtime::step(model, state, {force, force}, dt, workspace); }
  Scalar energy() { return runtime::energy(model, state, workspace.at_point); }
};

template <class Scalar>
Motion<Scalar> start(const model::Polynomial& polynomial, const runtime::Method<Scalar>& method, double dt,
                     const Eigen::VectorXd& z, double force = 0, const runtime::Damping& damping = {},
                     const runtime::NewtonOptions<Scalar>& options = {}) {
  using runtime::Vector;
  auto model = runtime::make_nonlinear_model<Scalar>(polynomial, damping);
  const Vector<Scalar> rest = Vector<Scalar>::Zero(model.size());
  const Vector<Scalar> load = Vector<Scalar>::Constant(model.size(), Scalar(force));
  auto state = runtime::make_state<Scalar>(model, method.history, z.cast<Scalar>(), rest, load);
  auto workspace = runtime::make_workspace<Scalar>(model, method, Scalar(dt), options);
  return {std::move(model), std::move(state), std::move(workspace), load, Scalar(dt)};
}

}  // namespace ritz::test
