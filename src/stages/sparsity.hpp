// The sparsity pattern of the matrices of a mesh: which vertices share a cell, and for K a 3 x 3 block for each pair of
// them, without what is fixed.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "ritz/algebra/csr.hpp"
#include "ritz/mesh/dofs.hpp"
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

/// Where the block of each entry of the vertex graph is stored in the rows of free degrees of freedom.
struct BlockPattern {
  VertexGraph graph;
  std::vector<PetscInt> offsets;  ///< of each graph entry: the number of columns before it in its part of the row
};

struct BlockRows {
  BlockPattern pattern;
  algebra::Rows rows;  ///< zeros
};

/// The complete rows of this rank's free degrees of freedom, filled with zeros.
BlockRows empty_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// The part of the rows that holds the column of local vertex `column`: `own` for this rank's vertices, `other` for
/// ghosts.
algebra::Csr& part(algebra::Rows& rows, const mesh::Mesh& mesh, int column);

/// Adds the 3 x 3 block of the vertices `row` (owned) and `column`, whose entry in the graph is `place`.
void add_block(algebra::Rows& rows, const BlockPattern& pattern, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
               std::size_t place, int row, int column, const Eigen::Matrix3d& block);

}  // namespace ritz::stages
