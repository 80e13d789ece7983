// The sets and vertices that a scene names, its loads as vectors of the full model, and the displacements of its
// probes.
#pragma once
#include <array>
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/full_statics.hpp"

namespace ritz::app {

/// The set that a force or a probe means by this name (base/set_name.hpp). Throws InputError for a set that the mesh
/// does not have (naming the nearest one), that is ambiguous, or that is empty.
const mesh::Set& find_set(const mesh::Mesh& mesh, const std::string& name);

/// The set that a pressure or a traction means by this name. Throws InputError as above, and for a set without boundary
/// faces; `what` is the kind of load in the message.
const mesh::Set& find_surface(const mesh::Mesh& mesh, const std::string& name, const std::string& what);

/// *Collective*. Throws InputError on all ranks when no rank owns a vertex with number `id` in the mesh file.
void require_vertex(const mesh::Mesh& mesh, std::int64_t id);

/// *Collective*. F(t) = Σ factor(table, t) force over the scene's loads, gravity g (M g) and ground acceleration (−M a
/// direction), N over the free degrees of freedom: dead loads on the body at rest. `scene` must outlive the result.
/// Throws InputError for a set or vertex that the mesh does not have, and for a pressure or traction on a set without a
/// surface.
stages::LoadAt scene_loads(const scene::Scene& scene, const stages::Problem& problem);

/// What a scene's probes measure.
class SceneProbes {
 public:
  /// *Collective*. Throws InputError as above.
  SceneProbes(const scene::Scene& scene, const mesh::Mesh& mesh);

  std::string header() const;  ///< t and the columns of scene::probe_columns, with commas between
  bool any(scene::Quantity quantity) const { return scene::any_measures(asked_, quantity); }
  /// *Collective*. The numbers of a row behind t: of a vertex, or the unweighted mean over a set. `moment` has the rows
  /// of owned vertices of each quantity (displacement, velocity, acceleration: m, m/s, m/s²) that a probe measures.
  Eigen::VectorXd at(const std::array<mesh::VertexRows, 3>& moment) const;

 private:
  struct Probe {
    std::vector<int> vertices;  ///< owned
    double total;               ///< number of vertices on all ranks
  };
  MPI_Comm comm_;
  std::vector<scene::Probe> asked_;
  std::vector<Probe> probes_;
};

}  // namespace ritz::app
