#include "ritz/stages/projection.hpp"

#include "ritz/mesh/dofs.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_loads.hpp"

namespace ritz::stages {

model::Inertia inertia(const mesh::Mesh& mesh, const algebra::Matrix& scalar_mass, mesh::VertexRef u) {
  const Eigen::Vector3d origin = mesh::bounding_box(mesh).middle();
  const Eigen::Index r = u.cols(), n = mesh.owned;
  algebra::Tall B(n, 4 + mesh::components * r);
  B.col(0).setOnes();
  B.middleCols<3>(1) = (mesh.points.leftCols(n).colwise() - origin).transpose();
  for (int c = 0; c < mesh::components; ++c)
    B.middleCols(4 + c * r, r) = u(Eigen::seqN(c, n, mesh::components), Eigen::all);
  const Eigen::MatrixXd gram = algebra::inner(mesh.comm, B, algebra::multiply(scalar_mass, B));
  return {origin, (gram + gram.transpose()) / 2};
}

namespace {

using Eigen::Index;

/// Σ_v w_v u_v for each component: r x 3.
Eigen::MatrixXd project(const mesh::Mesh& mesh, mesh::VertexRef u, const Eigen::VectorXd& weights) {
  Eigen::MatrixXd result(u.cols(), mesh::components);
  for (int c = 0; c < 3; ++c) {
    const algebra::Tall component = u(Eigen::seqN(c, mesh.owned, mesh::components), Eigen::all);
    result.col(c) = component.transpose() * weights;
  }
  parallel::sum_in_place(mesh.comm, result);
  return result;
}

void add_surface(const mesh::Mesh& mesh, const mesh::Set& set, mesh::VertexRef u, model::SetLoad& load) {
  const algebra::Tall weights = face_weights(mesh, set.faces);
  load.has_surface = true;
  load.area = parallel::sum(mesh.comm, weights.col(0).sum());
  load.traction = project(mesh, u, weights.col(0));
  load.pressure = Eigen::VectorXd::Zero(u.cols());
  for (int c = 0; c < 3; ++c) load.pressure += project(mesh, u, weights.col(1 + c)).col(c);
}

}  // namespace

std::vector<model::SetLoad> set_loads(const mesh::Mesh& mesh, mesh::VertexRef u) {
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
