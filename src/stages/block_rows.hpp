// The sparsity pattern of K: a 3 x 3 block for each pair of vertices that share a cell, without what is fixed.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "ritz/algebra/csr.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {

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
