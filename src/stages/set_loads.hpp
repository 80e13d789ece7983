// Unit loads on the named sets, projected onto the basis.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"

namespace ritz::stages {

/// *Collective*. Uᵀb for each named set that has vertices: for a unit total force shared equally by its vertices and,
/// if the set lies on the surface, for a unit pressure and a unit traction. `u` is the basis over owned vertices, 3
/// rows for each.
std::vector<model::SetLoad> set_loads(const mesh::Mesh& mesh, mesh::VertexRef u);

}  // namespace ritz::stages
