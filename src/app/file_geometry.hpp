// The mesh in file order: what the model file stores of it.
#pragma once
#include <span>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"
#include "ritz/parallel/redistribute.hpp"

namespace ritz::app {

/// This rank's slice of the stored geometry, and where rows of the mesh go.
struct FileGeometry {
  model::Geometry geometry;
  format::GeometrySlices slices;
  std::vector<std::int64_t> row_of_owned;  ///< stored row of each owned vertex, or -1 where it is not stored

  /// Values of owned vertices (`width` a vertex) as this rank's slice of stored rows. *Collective*.
  parallel::RowMatrix to_file(MPI_Comm comm, const parallel::RowMatrix& owned) const;
  std::vector<std::int64_t> to_file(MPI_Comm comm, std::span<const std::int64_t> owned) const;
};

/// One vector over owned vertices as a row x y z a vertex.
parallel::RowMatrix by_vertex(mesh::VertexRef u);

/// All vertices and solid cells, or the surface's vertices and faces. *Collective*.
FileGeometry file_geometry(const mesh::Mesh& mesh, const fem::Materials& materials, config::StoredRows rows);

}  // namespace ritz::app
