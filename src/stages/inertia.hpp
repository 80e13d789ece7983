// The Gram matrix that all inertia terms of a body are read off.
#pragma once
#include "ritz/mesh/mesh.hpp"
#include "ritz/model/model.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

/// G = Bᵀ M_s B with B = [1, X, Y, Z, U_x, U_y, U_z], coordinates relative to the middle of the bounding box.
/// `u`: the basis over owned vertices, 3 rows a vertex, zeros at fixed components. *Collective*.
model::Inertia inertia(const mesh::Mesh& mesh, Mat scalar_mass, mesh::VertexRef u);

}  // namespace ritz::stages
