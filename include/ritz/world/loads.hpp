// From a scene's loads and probes to reduced vectors.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// Three numbers of a scene as a vector.
Eigen::Vector3d vector(const scene::Vector3& v);

/// Uᵀf(t) = Σ factor(table, t) force over the terms.
struct ReducedLoad {
  struct Term {
    Eigen::VectorXd force;  ///< r
    std::optional<scene::Table> table;
  };
  std::vector<Term> terms;

  /// The load at time (or load fraction) t into `force`, which has its size r. Does not allocate.
  void evaluate(const scene::Scene& scene, double t, Eigen::Ref<Eigen::VectorXd> force) const;
};

/// Uᵀb, r x 3, for a unit force along x, y, z that the target's vertices share equally: a force f, N, on the target is
/// unit_force f on the reduced coordinates, and its transpose times z is the mean displacement of the target, m. Throws
/// InputError for a set or vertex that the model does not have, naming the nearest set.
Eigen::MatrixXd unit_force(const model::Body& body, const scene::Target& target);

/// Projects forces, pressures, gravity (UᵀMR_t g) and shaking (-UᵀMR_t a). Throws InputError for a set or vertex that
/// the model does not have, naming the nearest set, and for pressure or traction on a set without a surface.
ReducedLoad reduce_loads(const scene::Scene& scene, const model::Body& body);

/// The 3p x r matrix P: P z are the displacements x, y, z of the scene's p probes, m. The mean over a set is the dual
/// of a total force shared equally, so that it is known even where the set's vertices are not stored. Throws as above.
Eigen::MatrixXd probe_matrix(const scene::Scene& scene, const model::Body& body);

}  // namespace ritz::world
