// Loads that translate or rotate a body as a whole, on a model whose basis cannot represent that.
#pragma once
#include <cstdint>
#include <optional>

#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// What the loads of a scene do to a body whose basis leaves out its rigid motions.
enum class Push : unsigned char {
  moves_the_whole,  ///< they translate or rotate the body as a whole
  may_move_pieces,  ///< they may move pieces of the body against each other
  cannot_be_told    ///< the model does not store what is needed to decide
};

/// The rigid motions that a basis leaves out.
struct LeftOut {
  std::int64_t rigid_motions = 0;  ///< number of rigid modes of the body
  Push push = Push::moves_the_whole;
};

/// A basis of modal derivatives, snapshots or chosen modes is M-orthogonal to the rigid modes of its body: under loads
/// with a net force or torque such a model would not accelerate as a whole. Returns what the basis leaves out, or
/// nothing when lacks_motions(body) is false, when there are no loads, or when the loads are in equilibrium at all
/// times (to 1e-6 of the sum of their sizes). The basis lacks those rigid motions R for which UᵀMR is zero. If
/// lacks_motions(body), the body must have its inertia and its geometry.
std::optional<LeftOut> left_out_motions(const scene::Scene& scene, const model::Body& body);

/// Whether the basis may lack rigid motions: it does not consist of all modes, and the body has rigid modes.
bool lacks_motions(const model::Body& body);

}  // namespace ritz::world
