// The parts of a model that a run uses, and no others.
#pragma once
#include "ritz/format/parts.hpp"
#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"
#include "run_options.hpp"

namespace ritz::tools {

enum class Frames : unsigned char { none, some };

/// Reads the first body: its reduction or, where U is the modes, these; the polynomial if there is one and `forces`
/// wants it; points, cells and U for frames or single vertices; loads for named sets; inertia for gravity and shaking;
/// modes, geometry and inertia also where a reduction may leave out rigid motions.
/// Throws InputError when a part is missing or does not fit the others.
model::Body read_body(const format::ModelReader& in, const scene::Scene& scene, Frames frames, Forces forces);

/// What it takes to draw mode `index` (from 0): geometry, modes, and U with that column alone.
model::Body read_mode(const format::ModelReader& in, std::int64_t index);

}  // namespace ritz::tools
