// Loads that push or turn a body as a whole, on a model that cannot follow.
#pragma once
#include "ritz/format/parts.hpp"
#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::tools {

/// A basis of modal derivatives, snapshots or chosen modes is M-orthogonal to the rigid modes of its body: under loads
/// with a net force or torque it would neither fall nor fly. Throws InputError for a scene with such loads on such a
/// body; loads in equilibrium at all times pass, to 1e-6 of what they are one by one. Which rigid motions the basis
/// lacks is read off the Gram matrix: those that UᵀMR does not see.
void refuse_rigid_motion(const format::ModelReader& in, const scene::Scene& scene, const model::Body& body);

}  // namespace ritz::tools
