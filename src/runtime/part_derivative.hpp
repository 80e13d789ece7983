// The derivative of one part of a step, multiplied by that of the parts before it (chain rule).
#pragma once
#include "attempt.hpp"

namespace ritz::runtime {

/// For an implicit step, at the solution room.delta, before the state is advanced.
template <class Scalar>
void chain_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

/// For an explicit step, where its forces were evaluated last.
template <class Scalar>
void chain_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
