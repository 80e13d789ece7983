// Vectors that depend on nothing but the mesh file's vertex numbers.
#pragma once
#include <cstdint>

#include "ritz/mesh/dofs.hpp"

namespace ritz::stages {

/// Columns of numbers in [-1, 1), one for each free degree of freedom: the same on any number of ranks. They start
/// iterations and fix signs.
mesh::FreeRows fixed_vectors(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int columns, std::uint64_t stream);

}  // namespace ritz::stages
