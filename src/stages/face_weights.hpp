// The weights with which surface loads on the faces of a set act on the vertices.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// *Collective*. ∫ N_a dA and −∫ N_a n dA (n points out of the body), m², on the geometry at rest: 4 columns over owned
/// vertices. A traction t acts on the vertices with the first column times t, a pressure p that pushes into the body
/// with p times the other three.
algebra::Tall face_weights(const mesh::Mesh& mesh, const std::vector<mesh::CellFace>& faces);

}  // namespace ritz::stages
