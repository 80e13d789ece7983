// The rows of K: 3 x 3 blocks of vertices that share a cell, less what is fixed.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "ritz/mesh/dofs.hpp"
#include "ritz/petsc/csr.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {

/// Where the block of an entry of the vertex graph stands among the rows of free degrees of freedom.
struct BlockPattern {
  VertexGraph graph;
  std::vector<PetscInt> offsets;  ///< of a graph entry: how many columns stand before it in its part of a vertex's row
};

struct BlockRows {
  BlockPattern pattern;
  petsc::Rows rows;  ///< zeros
};

/// The complete rows of this rank's free degrees of freedom.
BlockRows empty_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// Columns of this rank's vertices stand in `own`, those of ghosts in `other`.
petsc::Csr& part(petsc::Rows& rows, const mesh::Mesh& mesh, int column);

/// Adds the block of vertices `row` (owned) and `column`, the entry `place` of the graph.
void add_block(petsc::Rows& rows, const BlockPattern& pattern, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
               std::size_t place, int row, int column, const Eigen::Matrix3d& block);

}  // namespace ritz::stages
