// The three things ritz-run can do with a body: let time pass, load it slowly, swing one of its modes. Here with linear
// models; run_nonlinear.hpp does the first two with nonlinear ones.
#pragma once
#include <cstdint>
#include <string>

#include "progress.hpp"
#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"
#include "run_recorder.hpp"

namespace ritz::tools {

/// What the stepping itself cost, without reading and recording.
struct Cost {
  std::int64_t steps = 0;
  double seconds = 0;
  std::int64_t iterations = 0;  ///< Newton's, of nonlinear models
  std::int64_t rejected = 0;    ///< steps that did not converge and were halved
  std::string balance = {};     ///< of the energy, a line; of undamped nonlinear motions
  std::string warning = {};     ///< a sentence, or nothing

  void add(const StepCost& step);
};

/// From rest at t = 0 to the scene's end. Throws NumericalError when a step is not finite.
Cost run_transient(const scene::Scene& scene, const scene::Time& time, const model::Body& body, Recorder& recorder,
                   Visible progress);

/// Load fractions 0, 1/steps, ... 1. Throws InputError when the load sets a free body moving.
Cost run_statics(const scene::Scene& scene, const scene::Static& statics, const model::Body& body, Recorder& recorder);

/// ψ sin ωt over one period of `frequency` Hz at `states` times, from 0; the period's end is its beginning and not
/// repeated. The largest displacement is a tenth of the diagonal of the body's bounding box. `body` as read_mode
/// returns it.
void swing_mode(const model::Body& body, double frequency, std::int64_t states, Recorder& recorder);

}  // namespace ritz::tools
