#include "ritz/stages/full_loads.hpp"

#include <algorithm>

#include "ritz/mesh/dofs.hpp"
#include "ritz/stages/face_weights.hpp"

namespace ritz::stages {
namespace {

/// w_v f on every vertex.
algebra::Tall spread(const Eigen::VectorXd& weights, const Eigen::Vector3d& f) {
  algebra::Tall force(mesh::components * weights.size(), 1);
  for (Eigen::Index v = 0; v < weights.size(); ++v) mesh::at_vertex(force.col(0), v) = weights[v] * f;
  return force;
}

}  // namespace

mesh::VertexRows shared_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& newton) {
  Eigen::VectorXd share = Eigen::VectorXd::Zero(mesh.owned);
  for (const int v : set.vertices)
    if (v < mesh.owned) share[v] = 1 / static_cast<double>(set.vertices_total);
  return spread(share, newton);
}

mesh::VertexRows vertex_force(const mesh::Mesh& mesh, mesh::Index id, const Eigen::Vector3d& newton) {
  Eigen::VectorXd here = Eigen::VectorXd::Zero(mesh.owned);
  const auto end = mesh.ids.begin() + mesh.owned;
  if (const auto found = std::find(mesh.ids.begin(), end, id); found != end) here[found - mesh.ids.begin()] = 1;
  return spread(here, newton);
}

mesh::VertexRows traction_force(const mesh::Mesh& mesh, const mesh::Set& set, const Eigen::Vector3d& pascal) {
  return spread(face_weights(mesh, set.faces).col(0), pascal);
}

mesh::VertexRows pressure_force(const mesh::Mesh& mesh, const mesh::Set& set, double pascal) {
  const algebra::Tall weights = face_weights(mesh, set.faces);
  algebra::Tall force(mesh::components * mesh.owned, 1);
  for (int v = 0; v < mesh.owned; ++v) mesh::at_vertex(force.col(0), v) = pascal * weights.row(v).tail<3>().transpose();
  return force;
}

mesh::VertexRows body_force(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass,
                            const Eigen::Vector3d& acceleration) {
  return spread(algebra::multiply(scalar_mass, algebra::Tall::Ones(mesh.owned, 1)), acceleration);
}

}  // namespace ritz::stages
