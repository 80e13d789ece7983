// Loads that push or turn a body as a whole, on a model that cannot follow.
#pragma once
#include <cstdint>
#include <optional>

#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// What a scene's loads do to a body whose basis leaves out its rigid motions.
enum class Push : unsigned char {
  moves_the_whole,  ///< they push or turn it as a whole
  may_move_pieces,  ///< they may move its pieces against each other
  cannot_be_told    ///< the model does not store what tells
};

struct LeftOut {
  std::int64_t rigid_motions = 0;
  Push push = Push::moves_the_whole;
};

/// A basis of modal derivatives, snapshots or chosen modes is M-orthogonal to the rigid modes of its body: under loads
/// with a net force or torque it would neither fall nor fly. Nothing for loads in equilibrium at all times, to 1e-6 of
/// what they are one by one. Which rigid motions the basis lacks is read off the Gram matrix: those that UᵀMR does not
/// see. The body has its inertia, and its geometry where its basis may lack motions (lacks_motions).
std::optional<LeftOut> left_out_motions(const scene::Scene& scene, const model::Body& body);

/// Whether the basis is not of all modes and the body has rigid ones.
bool lacks_motions(const model::Body& body);

}  // namespace ritz::world
