// Dead loads on the full model: forces on the body at rest that stay as they are while it moves.
// Each result: N, one column over owned vertices, 3 rows a vertex, at fixed components too.
#pragma once
#include "ritz/mesh/mesh.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

/// A force shared equally by all vertices of the set, which must have some.
mesh::VertexRows shared_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& newton);

/// A force on the vertex with the mesh file's own number `id`; zeros where another rank owns it.
mesh::VertexRows vertex_force(const mesh::Mesh& mesh, mesh::Index id, const Eigen::Vector3d& newton);

/// Consistent: ∫ N_a t dA. *Collective*.
mesh::VertexRows traction_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& pascal);

/// −p ∫ N_a n dA, positive pushes into the body. *Collective*.
mesh::VertexRows pressure_force(const mesh::Mesh& mesh, const mesh::Set& set, double pascal);

/// M g for the same acceleration g (m/s²) everywhere; `scalar_mass` as in Full. *Collective*.
mesh::VertexRows body_force(const mesh::Mesh& mesh, Mat scalar_mass, const Eigen::Vector3d& acceleration);

}  // namespace ritz::stages
