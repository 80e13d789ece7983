// From a scene's loads and probes to vectors of the full model.
#pragma once
#include <vector>

#include "ritz/scene/scene.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/full_statics.hpp"

namespace ritz::app {

/// F(t) = Σ factor(table, t) force over the scene's loads, gravity (M g) and shaking (−M a direction), N over the free
/// degrees of freedom; dead loads on the body at rest. `scene` must outlive it. Throws InputError for a set or vertex
/// that the mesh does not have, and for pressure or traction on a set without a surface. *Collective*.
stages::LoadAt scene_loads(const scene::Scene& scene, const stages::Problem& problem);

/// Displacements of the scene's probes.
class SceneProbes {
 public:
  /// Throws as above. *Collective*.
  SceneProbes(const scene::Scene& scene, const mesh::Mesh& mesh);

  std::string header() const;  ///< "t,NAME_ux,NAME_uy,NAME_uz,..."
  /// 3 a probe, m: a vertex's, or the plain mean over a set. `u`: rows of owned vertices. *Collective*.
  Eigen::VectorXd at(mesh::VertexRef u) const;

 private:
  struct Probe {
    std::string name;
    std::vector<int> vertices;  ///< owned
    double total;               ///< of vertices on all ranks
  };
  MPI_Comm comm_;
  std::vector<Probe> probes_;
};

}  // namespace ritz::app
