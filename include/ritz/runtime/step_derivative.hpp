// The linearisation of a step: the derivative of the new state with respect to the old state and to the load.
#pragma once
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// With the h columns of the history one below the other in y, h r numbers,
///   dy_{n+1} = state dy_n + begin df_n + end df_{n+1}.
/// Of a carried body the first six of dy are small motions of the frame by its own axes (frame.hpp), before and after.
template <class Scalar>
struct StepDerivative {
  Matrix<Scalar> state;       ///< h r x h r
  Matrix<Scalar> begin, end;  ///< h r x r
};

/// Allocates the derivative for this model and integrator.
template <class Scalar>
StepDerivative<Scalar> make_step_derivative(const Model<Scalar>& model, const Integrator& integrator);

/// Makes a step as above and writes its derivative; for a step that was halved, by the chain rule over its parts. The
/// derivative is that of the exact solution of the step's equation, evaluated at the solution that was found. On
/// failure `derivative` is left as it was.
template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace, StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
