// Time and statics with a nonlinear model: a body that has its polynomial.
#pragma once
#include "run_analysis.hpp"
#include "run_options.hpp"

namespace ritz::tools {

/// From rest at t = 0 to the scene's end, with "avf" unless the scene says otherwise. A step that does not converge is
/// halved and counted; throws NumericalError where that does not help, InputError for the integrator "exact". The cost
/// carries a warning where an undamped motion gained energy without work.
Cost run_nonlinear_transient(const scene::Scene& scene, const scene::Time& time, const model::Body& body,
                             Precision precision, Recorder& recorder, Visible progress);

/// Load fractions 0, 1/steps, ... 1, the load straight between them. Throws NumericalError at a limit point and
/// InputError for a free body.
Cost run_nonlinear_statics(const scene::Scene& scene, const scene::Static& statics, const model::Body& body,
                           Precision precision, Recorder& recorder);

}  // namespace ritz::tools
