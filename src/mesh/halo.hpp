// Exchange of values at vertices that other ranks own.
#pragma once
#include <vector>

#include "ritz/mesh/rows.hpp"

namespace ritz::mesh {

struct Mesh;

/// The vertices that this rank shares with another one, by local number.
struct SharedVertices {
  int rank;
  std::vector<int> vertices;
};

/// The communication plan for ghost vertices. It is made once with the mesh, and serves every exchange.
class Halo {
 public:
  Halo() = default;
  /// *Collective*.
  explicit Halo(const Mesh& mesh);

  /// *Collective*. Fills the rows of the ghosts in `local` with the rows of their owning ranks: `numbers` rows for each
  /// local vertex, any number of columns. The rows of owned vertices must be set. Allocates nothing after the first
  /// exchange of this size.
  void fill_ghosts(MPI_Comm comm, LocalRows& local, int numbers) const;

 private:
  std::vector<SharedVertices> sent_;      ///< owned vertices that are ghosts of `rank`, in the order expected there
  std::vector<SharedVertices> received_;  ///< ghosts that `rank` owns
  mutable std::vector<double> out_, in_;  ///< send and receive buffers, kept between exchanges
  mutable std::vector<MPI_Request> requests_;
};

/// *Collective*. From rows of owned vertices, `numbers` for each vertex, to rows of all local vertices, with the
/// ghosts' values from their owning ranks.
LocalRows with_ghosts(const Mesh& mesh, VertexRef u, int numbers);

}  // namespace ritz::mesh
