#include "ritz/stages/set_loads.hpp"

#include "ritz/fem/face.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/accumulate.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

/// What the faces of a set put on each vertex: ∫ N_a dA and −∫ N_a n dA, 4 columns over owned vertices.
petsc::Tall face_weights(const mesh::Mesh& mesh, const std::vector<mesh::CellFace>& faces) {
  std::vector<std::int64_t> numbers;
  std::vector<double> rows;
  for (const auto face : faces) {
    const auto vertices = mesh::face_vertices(mesh, face);
    const auto type = fem::shape(mesh.cells.types[static_cast<std::size_t>(face.cell)]).face;
    fem::visit(type, [&]<class F>(F) {
      fem::Coordinates<F> x;
      for (int a = 0; a < F::vertices; ++a) x.col(a) = mesh.points.col(vertices[static_cast<std::size_t>(a)]);
      const auto weights = fem::traction_weights<F>(x);
      const auto normals = fem::pressure_vectors<F>(x);
      for (int a = 0; a < F::vertices; ++a) {
        numbers.push_back(mesh.global[static_cast<std::size_t>(vertices[static_cast<std::size_t>(a)])]);
        rows.insert(rows.end(), {weights[a], -normals(0, a), -normals(1, a), -normals(2, a)});
      }
    });
  }
  const petsc::Tall values = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>>(
      rows.data(), static_cast<Index>(numbers.size()), 4);
  return petsc::accumulate(mesh.comm, numbers, values, mesh.owned);
}

/// Σ_v w_v u_v for each component: r x 3.
Eigen::MatrixXd project(const mesh::Mesh& mesh, const petsc::ConstTallRef& u, const Eigen::VectorXd& weights) {
  Eigen::MatrixXd result(u.cols(), 3);
  for (int c = 0; c < 3; ++c) {
    const petsc::Tall component = u(Eigen::seqN(c, mesh.owned, 3), Eigen::all);
    result.col(c) = component.transpose() * weights;
  }
  parallel::sum_in_place(mesh.comm, result);
  return result;
}

void add_surface(const mesh::Mesh& mesh, const mesh::Set& set, const petsc::ConstTallRef& u, model::SetLoad& load) {
  const petsc::Tall weights = face_weights(mesh, set.faces);
  load.has_surface = true;
  load.area = parallel::sum(mesh.comm, weights.col(0).sum());
  load.traction = project(mesh, u, weights.col(0));
  load.pressure = Eigen::VectorXd::Zero(u.cols());
  for (int c = 0; c < 3; ++c) load.pressure += project(mesh, u, weights.col(1 + c)).col(c);
}

}  // namespace

std::vector<model::SetLoad> set_loads(const mesh::Mesh& mesh, const petsc::ConstTallRef& u) {
  std::vector<model::SetLoad> loads;
  for (const auto& set : mesh.sets) {
    if (set.vertices_total == 0) continue;
    Eigen::VectorXd share = Eigen::VectorXd::Zero(mesh.owned);
    for (const int v : set.vertices)
      if (v < mesh.owned) share[v] = 1.0 / static_cast<double>(set.vertices_total);
    model::SetLoad load;
    load.set = set.name;
    load.vertices = set.vertices_total;
    load.total = project(mesh, u, share);
    if (set.faces_total > 0) add_surface(mesh, set, u, load);
    loads.push_back(std::move(load));
  }
  return loads;
}

}  // namespace ritz::stages
