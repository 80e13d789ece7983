// The linearisation of a step: how the new state changes with the old one and with the load.
#pragma once
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// With y the history's columns one below the other, h r numbers:
///   dy_{n+1} = state dy_n + begin df_n + end df_{n+1}.
/// Of a carried body the first six of dy are small motions of the frame by its own axes (frame.hpp), before and after.
template <class Scalar>
struct StepDerivative {
  Matrix<Scalar> state;       ///< h r x h r
  Matrix<Scalar> begin, end;  ///< h r x r
};

template <class Scalar>
StepDerivative<Scalar> make_step_derivative(const Model<Scalar>& model, const Integrator& integrator);

/// As `step`, and its derivative: the chain of the parts that it took, where it was halved. The derivative is that at
/// the solution, whatever Newton's method left of the residual. Where the step fails it is not touched.
template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace, StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
