// Values at the vertices of other ranks.
#pragma once
#include <vector>

#include "ritz/mesh/rows.hpp"

namespace ritz::mesh {

struct Mesh;

/// The vertices that this rank has in common with another one, by local number.
struct SharedVertices {
  int rank;
  std::vector<int> vertices;
};

/// Who tells whom about which vertices. It is made once, with the mesh, and serves every exchange.
class Halo {
 public:
  Halo() = default;
  /// *Collective*.
  explicit Halo(const Mesh& mesh);

  /// Fills the rows of ghosts in `local` from their owners' rows: `numbers` rows a local vertex, any number of columns.
  /// The rows of owned vertices must be there. Allocates nothing once an exchange of this size was made. *Collective*.
  void fill_ghosts(MPI_Comm comm, LocalRows& local, int numbers) const;

 private:
  std::vector<SharedVertices> sent_;      ///< owned vertices that are ghosts of `rank`, in the order that it expects
  std::vector<SharedVertices> received_;  ///< ghosts that `rank` owns
  mutable std::vector<double> out_, in_;  ///< scratch of an exchange; its size is kept
  mutable std::vector<MPI_Request> requests_;
};

/// Rows of owned vertices, `numbers` a vertex -> rows of all local vertices: ghosts' values come from their owners.
/// *Collective*.
LocalRows with_ghosts(const Mesh& mesh, VertexRef u, int numbers);

}  // namespace ritz::mesh
