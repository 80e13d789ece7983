// Steps of oscillators from a table.
#pragma once
#include "ritz/runtime/step_derivative.hpp"

namespace ritz::runtime {

template <class Scalar>
OscillatorTables<Scalar> make_tables(const Model<Scalar>& model, const Integrator& integrator, Scalar dt);

/// Tabulates for another length of step where `dt` is one, then steps; the derivative where one is wanted.
template <class Scalar>
Outcome step_from_tables(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load, Scalar dt,
                         const Integrator& integrator, OscillatorTables<Scalar>& tables,
                         StepDerivative<Scalar>* derivative);

}  // namespace ritz::runtime
