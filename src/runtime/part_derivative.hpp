// The derivative of one part of a step, chained to that of the parts before.
#pragma once
#include "attempt.hpp"

namespace ritz::runtime {

/// At the solution δ in the room, before the state is advanced.
template <class Scalar>
void chain_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

/// Where the explicit step's forces were evaluated last.
template <class Scalar>
void chain_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
