// The Gram matrix from which all inertia terms of a body are computed.
#pragma once
#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"

namespace ritz::stages {

/// *Collective*. G = Bᵀ M_s B with B = [1, X, Y, Z, U_x, U_y, U_z], the coordinates relative to the centre of the
/// bounding box. `u` is the basis over owned vertices, 3 rows for each, with zeros at fixed components.
model::Inertia inertia(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass, mesh::VertexRef u);

}  // namespace ritz::stages
