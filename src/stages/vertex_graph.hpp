// Which vertices share a cell: the block pattern of every sparse matrix of the mesh.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// Rows: owned vertices; columns: local vertices, ascending by global number within a row.
struct VertexGraph {
  std::vector<std::size_t> starts = {0};
  std::vector<int> columns;

  /// The place in `columns` of entry (row, column), which must exist.
  std::size_t place(const std::vector<mesh::Index>& global, int row, int column) const;
};

VertexGraph vertex_graph(const mesh::Mesh& mesh);

/// For each local vertex the local cells around it, in the file's order of cells.
struct CellsOfVertices {
  std::vector<std::size_t> starts;
  std::vector<int> cells;
};

CellsOfVertices cells_of_vertices(const mesh::Mesh& mesh);

}  // namespace ritz::stages
