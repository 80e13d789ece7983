// The mass of a body, and unit loads on its named sets, projected onto the basis.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"

namespace ritz::stages {

/// *Collective*. G = Bᵀ M_s B with B = [1, X, Y, Z, U_x, U_y, U_z], the coordinates relative to the centre of the
/// bounding box. `u` is the basis over owned vertices, 3 rows for each, with zeros at fixed components.
model::Inertia inertia(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass, mesh::VertexRef u);

/// *Collective*. Uᵀb for each named set that has vertices: for a unit total force shared equally by its vertices and,
/// if the set lies on the surface, for a unit pressure and a unit traction. `u` is the basis over owned vertices, 3
/// rows for each.
std::vector<model::SetLoad> set_loads(const mesh::Mesh& mesh, mesh::VertexRef u);

}  // namespace ritz::stages
