#include "support/statics.hpp"

#include "ritz/algebra/factorization.hpp"
#include "ritz/algebra/multivector.hpp"
#include "ritz/fem/face.hpp"

namespace ritz::test {

algebra::Tall end_traction(const Problem& p, const std::string& set, const Eigen::Vector3d& total) {
  const mesh::Mesh& mesh = p.mesh;
  std::vector<std::int64_t> numbers;
  std::vector<double> weights;
  for (const auto face : mesh.find(set)->faces) {
    const auto vertices = mesh::face_vertices(mesh, face);
    const auto type = fem::side(mesh.cells.types[static_cast<std::size_t>(face.cell)], face.face).type;
    const auto w = fem::traction_weights(type, mesh.points(Eigen::all, vertices));
    weights.insert(weights.end(), w.data(), w.data() + w.size());
    for (const int v : vertices) numbers.push_back(mesh.global[static_cast<std::size_t>(v)]);
  }
  const Eigen::Map<const Eigen::VectorXd> rows(weights.data(), static_cast<Eigen::Index>(weights.size()));
  const algebra::Tall at_vertices = algebra::accumulate(mesh.comm, numbers, rows, mesh.owned);
  const double area = algebra::inner(mesh.comm, at_vertices, algebra::Tall::Ones(mesh.owned, 1))(0, 0);
  algebra::Tall force(3 * mesh.owned, 1);
  for (int c = 0; c < 3; ++c) force.col(0)(Eigen::seqN(c, mesh.owned, 3)) = total[c] / area * at_vertices.col(0);
  return mesh::from_vertices(mesh, p.dofs, force);
}

algebra::Tall solve(const Problem& p, const algebra::Tall& force) {
  algebra::Factorization solver(p.mesh.comm, "statics_");
  solver.factor(p.matrices.stiffness, p.matrices.mass, 0);
  algebra::Tall u(force.rows(), force.cols());
  solver.solve(force, u);
  return u;
}

double work(const Problem& p, const algebra::Tall& force, const algebra::Tall& u) {
  return algebra::inner(p.mesh.comm, force, u)(0, 0);
}

}  // namespace ritz::test
