// Steps of oscillators from a table.
#pragma once
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// The table of steps of `dt` seconds. Throws InputError when the integrator is not stable at this `dt`.
template <class Scalar>
OscillatorTables<Scalar> make_tables(const Model<Scalar>& model, const Integrator& integrator, Scalar dt);

/// Steps from the table, which is computed again if `dt` is another length; also writes the derivative if `derivative`
/// is not null.
template <class Scalar>
Outcome step_from_tables(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load, Scalar dt,
                         const Integrator& integrator, OscillatorTables<Scalar>& tables,
                         StepDerivative<Scalar>* derivative);

}  // namespace ritz::runtime
