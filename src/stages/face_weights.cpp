#include "ritz/stages/face_weights.hpp"

#include "ritz/algebra/multivector.hpp"
#include "ritz/fem/face.hpp"

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

}  // namespace ritz::stages
