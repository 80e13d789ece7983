// What the faces of a set put on each vertex.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

/// ∫ N_a dA and −∫ N_a n dA (n out of the body), m², on the geometry at rest: 4 columns over owned vertices. A traction
/// t puts the first column times t on the vertices, a pressure p that pushes into the body p times the other three.
/// *Collective*.
petsc::Tall face_weights(const mesh::Mesh& mesh, const std::vector<mesh::CellFace>& faces);

}  // namespace ritz::stages
