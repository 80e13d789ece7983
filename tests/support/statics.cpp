#include "support/statics.hpp"

#include "ritz/fem/face.hpp"
#include "ritz/petsc/factorization.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::test {

petsc::Tall end_traction(const Problem& p, const std::string& set, const Eigen::Vector3d& total) {
  const mesh::Mesh& mesh = p.mesh;
  std::vector<std::int64_t> numbers;
  std::vector<double> weights;
  for (const auto face : mesh.find(set)->faces) {
    const auto vertices = mesh::face_vertices(mesh, face);
    fem::visit(fem::shape(mesh.cells.types[static_cast<std::size_t>(face.cell)]).face, [&]<class F>(F) {
      const auto w = fem::traction_weights<F>(fem::Coordinates<F>(mesh.points(Eigen::all, vertices)));
      weights.insert(weights.end(), w.begin(), w.end());
    });
    for (const int v : vertices) numbers.push_back(mesh.global[static_cast<std::size_t>(v)]);
  }
  const Eigen::Map<const Eigen::VectorXd> rows(weights.data(), static_cast<Eigen::Index>(weights.size()));
  const petsc::Tall at_vertices = petsc::accumulate(mesh.comm, numbers, rows, mesh.owned);
  const double area = petsc::inner(mesh.comm, at_vertices, petsc::Tall::Ones(mesh.owned, 1))(0, 0);
  petsc::Tall force(3 * mesh.owned, 1);
  for (int c = 0; c < 3; ++c) force.col(0)(Eigen::seqN(c, mesh.owned, 3)) = total[c] / area * at_vertices.col(0);
  return mesh::from_vertices(mesh, p.dofs, force);
}

petsc::Tall solve(const Problem& p, const petsc::Tall& force) {
  petsc::Factorization solver(p.mesh.comm, "statics_");
  solver.factor(p.matrices.stiffness, p.matrices.mass, 0);
  petsc::Tall u(force.rows(), force.cols());
  solver.solve(force, u);
  return u;
}

double work(const Problem& p, const petsc::Tall& force, const petsc::Tall& u) {
  return petsc::inner(p.mesh.comm, force, u)(0, 0);
}

}  // namespace ritz::test
