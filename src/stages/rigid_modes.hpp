// The rigid modes of a body, from its connectivity and its supports.
#pragma once
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// *Collective*. A basis of the null space of K over the free degrees of freedom: the rigid motions of the pieces of
/// the body (parts connected through faces) that agree at shared vertices and satisfy the supports. A free piece has 6,
/// two pieces that share a vertex 9, that share an edge 7; a body with enough supports has 0.
///
/// Each piece has 6 coordinates. Each shared vertex and each fixed degree of freedom gives rows of a small matrix,
/// whose null space is computed by SVD. The columns are not yet orthonormal.
mesh::FreeRows rigid_motions(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// *Collective*. The six rigid motions of the whole body, regardless of pieces and supports: the near-null space for
/// multigrid.
mesh::FreeRows near_null_space(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

}  // namespace ritz::stages
