// Dead loads on the full model: forces on the body at rest, which do not change while it moves. Each *_force has one
// column over owned vertices, N, 3 rows for each vertex, fixed components included.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// *Collective*. ∫ N_a dA and −∫ N_a n dA (n points out of the body), m², on the geometry at rest: 4 columns over owned
/// vertices. A traction t acts on the vertices with the first column times t, a pressure p that pushes into the body
/// with p times the other three.
algebra::Tall face_weights(const mesh::Mesh& mesh, const std::vector<mesh::CellFace>& faces);

/// A force that all vertices of the set, which must not be empty, share equally.
mesh::VertexRows shared_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& newton);

/// A force on the vertex with number `id` in the mesh file; zeros on ranks that do not own it.
mesh::VertexRows vertex_force(const mesh::Mesh& mesh, mesh::Index id, const Eigen::Vector3d& newton);

/// *Collective*. The consistent forces ∫ N_a t dA of a traction t.
mesh::VertexRows traction_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& pascal);

/// *Collective*. The consistent forces −p ∫ N_a n dA of a pressure p; a positive p pushes into the body.
mesh::VertexRows pressure_force(const mesh::Mesh& mesh, const mesh::Set& set, double pascal);

/// *Collective*. M g for an acceleration g (m/s²) that is the same everywhere; `scalar_mass` is that of Matrices.
mesh::VertexRows body_force(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass,
                            const Eigen::Vector3d& acceleration);

}  // namespace ritz::stages
