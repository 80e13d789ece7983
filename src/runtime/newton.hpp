// One attempt at one step: the equation is solved, or not; the state is only read.
#pragma once
#include "ritz/runtime/nonlinear_step.hpp"

namespace ritz::runtime {

/// Solves R(δ) = 0 by Newton's method from δ = 0 into workspace.delta, for the equation in the workspace.
template <class Scalar>
NonlinearOutcome newton(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                        NonlinearWorkspace<Scalar>& workspace);

/// Puts z''_{n+1} of an explicit step of dt seconds under the force `load` at its end into workspace.delta.
template <class Scalar>
NonlinearOutcome explicit_acceleration(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
                                       VectorRef<Scalar> load, Scalar dt, NonlinearWorkspace<Scalar>& workspace);

}  // namespace ritz::runtime
