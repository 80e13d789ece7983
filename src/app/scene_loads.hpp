// The loads and probes of a scene as vectors of the full model.
#pragma once
#include <vector>

#include "ritz/scene/scene.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/full_statics.hpp"

namespace ritz::app {

/// *Collective*. F(t) = Σ factor(table, t) force over the scene's loads, gravity g (M g) and ground acceleration (−M a
/// direction), N over the free degrees of freedom: dead loads on the body at rest. `scene` must outlive the result.
/// Throws InputError for a set or vertex that the mesh does not have, and for a pressure or traction on a set without a
/// surface.
stages::LoadAt scene_loads(const scene::Scene& scene, const stages::Problem& problem);

/// The displacements of a scene's probes.
class SceneProbes {
 public:
  /// *Collective*. Throws InputError as above.
  SceneProbes(const scene::Scene& scene, const mesh::Mesh& mesh);

  std::string header() const;  ///< "t,NAME_ux,NAME_uy,NAME_uz,..."
  /// *Collective*. Three numbers for each probe, m: the displacement of a vertex, or the unweighted mean over a set.
  /// `u` has rows of owned vertices.
  Eigen::VectorXd at(mesh::VertexRef u) const;

 private:
  struct Probe {
    std::string name;
    std::vector<int> vertices;  ///< owned
    double total;               ///< number of vertices on all ranks
  };
  MPI_Comm comm_;
  std::vector<Probe> probes_;
};

}  // namespace ritz::app
