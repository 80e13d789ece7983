#include "ritz/stages/full_loads.hpp"

#include <algorithm>

#include "ritz/fem/face.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::stages {

algebra::Tall face_weights(const mesh::Mesh& mesh, const std::vector<mesh::CellFace>& faces) {
  std::vector<std::int64_t> numbers;
  std::vector<double> rows;
  for (const auto face : faces) {
    const auto vertices = mesh::face_vertices(mesh, face);
    const auto type = fem::side(mesh.cells.types[static_cast<std::size_t>(face.cell)], face.face).type;
    fem::FaceVectors x(3, static_cast<int>(vertices.size()));
    for (int a = 0; a < x.cols(); ++a) x.col(a) = mesh.points.col(vertices[static_cast<std::size_t>(a)]);
    const auto weights = fem::traction_weights(type, x);
    const auto normals = fem::pressure_vectors(type, x);
    for (int a = 0; a < x.cols(); ++a) {
      numbers.push_back(mesh.global[static_cast<std::size_t>(vertices[static_cast<std::size_t>(a)])]);
      rows.insert(rows.end(), {weights(a), -normals(0, a), -normals(1, a), -normals(2, a)});
    }
  }
  const algebra::Tall values = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>>(
      rows.data(), static_cast<Eigen::Index>(numbers.size()), 4);
  return algebra::accumulate(mesh.comm, numbers, values, mesh.owned);
}

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
