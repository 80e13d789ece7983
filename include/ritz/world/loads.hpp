// Projects the loads and probes of a scene onto reduced coordinates.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// A vector of a scene as one of Eigen.
Eigen::Vector3d vector(const scene::Vector3& v);

/// The reduced load Uᵀf(t) = Σ factor(table, t) force, a sum over the terms.
struct ReducedLoad {
  struct Term {
    Eigen::VectorXd force;  ///< r numbers, N/√kg
    std::optional<scene::Table> table;
  };
  std::vector<Term> terms;

  /// Writes the load at time t (s; in statics the load fraction) to `force`, which already has its size r. Does not
  /// allocate.
  void evaluate(const scene::Scene& scene, double t, Eigen::Ref<Eigen::VectorXd> force) const;
};

/// Uᵀb, r x 3, 1/√kg, for a unit force along x, y, z that the vertices of the target share equally. A force f (N) on
/// the target is unit_force f on the reduced coordinates, and unit_forceᵀ z is the mean displacement of the target, m.
/// Throws InputError for a set that the model does not have (naming the nearest one), that is ambiguous or that is
/// empty, and for a vertex that is not stored.
Eigen::MatrixXd unit_force(const model::Body& body, const scene::Target& target);

/// Projects forces, pressures, tractions, gravity g (UᵀMR_t g) and ground acceleration a (−UᵀMR_t a), with the unit
/// translations R_t. Throws InputError as unit_force does, and for a pressure or traction on a set without a surface.
ReducedLoad reduce_loads(const scene::Scene& scene, const model::Body& body);

/// The 3p x r matrix P, 1/√kg: P z are the displacements along x, y, z of the p probes of the scene, m, P z' and P z''
/// their velocities and accelerations. The mean over a
/// set is the transpose of its unit_force, and so is known even where the vertices of the set are not stored. Throws
/// InputError as unit_force does.
Eigen::MatrixXd probe_matrix(const scene::Scene& scene, const model::Body& body);

}  // namespace ritz::world
