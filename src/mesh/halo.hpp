// Values at the vertices of other ranks.
#pragma once
#include "ritz/mesh/mesh.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::mesh {

/// Rows of owned vertices, 3 a vertex -> rows of all local vertices: ghosts' values from their owners. *Collective*.
petsc::Tall with_ghosts(const Mesh& mesh, const petsc::ConstTallRef& u);

}  // namespace ritz::mesh
