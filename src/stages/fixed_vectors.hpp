// Pseudo-random vectors that depend on the vertex numbers of the mesh file alone.
#pragma once
#include <cstdint>

#include "ritz/mesh/dofs.hpp"

namespace ritz::stages {

/// Columns of numbers in [-1, 1), one for each free degree of freedom, the same on any number of ranks. They start
/// iterations and determine signs.
mesh::FreeRows fixed_vectors(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int columns, std::uint64_t stream);

}  // namespace ritz::stages
