// The rigid modes of a body, from its connectivity and its supports.
#pragma once
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// A basis of the null space of K over the free degrees of freedom: how the pieces of the body (parts connected through
/// faces) can move rigidly, together where they share vertices and where supports hold them. A free piece has 6, two
/// pieces that share a vertex 9, an edge 7; a body on enough supports 0.
///
/// The space is found in the 6 coordinates a piece: each shared vertex and each fixed degree of freedom is a row of a
/// small matrix, whose null space (by SVD) it is. The columns are not yet orthonormal. *Collective*.
mesh::FreeRows rigid_motions(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// The six motions of the body as a whole, whatever its pieces and supports: the near-null space that multigrid wants.
/// *Collective*.
mesh::FreeRows near_null_space(const mesh::Mesh& mesh, const mesh::Dofs& dofs);

}  // namespace ritz::stages
