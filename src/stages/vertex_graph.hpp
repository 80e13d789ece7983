// Which vertices share a cell: the block sparsity pattern of every matrix of the mesh.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// Compressed rows: one row for each owned vertex, whose columns are local vertices by ascending global number.
struct VertexGraph {
  std::vector<std::size_t> starts = {0};
  std::vector<int> columns;

  /// The position in `columns` of the entry (row, column), which must exist.
  std::size_t place(const std::vector<mesh::Index>& global, int row, int column) const;
};

VertexGraph vertex_graph(const mesh::Mesh& mesh);

/// For each local vertex the local cells around it, in the order of cells in the file.
struct CellsOfVertices {
  std::vector<std::size_t> starts;
  std::vector<int> cells;
};

CellsOfVertices cells_of_vertices(const mesh::Mesh& mesh);

}  // namespace ritz::stages
