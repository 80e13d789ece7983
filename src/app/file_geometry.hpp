// The mesh in the order of its file, as the model file stores it.
#pragma once
#include <span>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"
#include "ritz/parallel/redistribute.hpp"

namespace ritz::app {

/// This rank's slice of the stored geometry, and the mapping from rows of the mesh.
struct FileGeometry {
  model::Geometry geometry;
  format::GeometrySlices slices;
  std::vector<std::int64_t> row_of_owned;  ///< the stored row of each owned vertex, or -1 if it is not stored

  /// *Collective*. Redistributes values of owned vertices, one row for each, to this rank's slice of the stored rows.
  parallel::RowMatrix to_file(MPI_Comm comm, const parallel::RowMatrix& owned) const;
  std::vector<std::int64_t> to_file(MPI_Comm comm, std::span<const std::int64_t> owned) const;
};

/// A vector over owned vertices as a matrix with one row x, y, z for each vertex.
parallel::RowMatrix by_vertex(mesh::VertexRef u);

/// The materials of all regions with the names of these.
std::vector<model::RegionMaterial> named_materials(const mesh::Mesh& mesh, const fem::Materials& materials);

/// *Collective*. All vertices and solid cells, or only the vertices and faces of the surface.
FileGeometry file_geometry(const mesh::Mesh& mesh, const fem::Materials& materials, config::StoredRows rows);

}  // namespace ritz::app
