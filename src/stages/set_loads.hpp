// Unit loads on the named sets, projected onto the basis.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

/// Uᵀb for each named set that has vertices: a unit total force shared equally by its vertices; and, where it bounds
/// the body, a unit pressure and a unit traction. `u`: the basis over owned vertices, 3 rows a vertex. *Collective*.
std::vector<model::SetLoad> set_loads(const mesh::Mesh& mesh, mesh::VertexRef u);

}  // namespace ritz::stages
