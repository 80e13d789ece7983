#include "ritz/stages/internal_force.hpp"

#include "ritz/fem/response.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

template <class E>
void add_cell(const mesh::Mesh& mesh, const Cell<E>& cell, const mesh::LocalRows& local, InternalForces& sums) {
  for (Eigen::Index j = 0; j < local.cols(); ++j) {
    const auto [energy, force] = fem::energy_and_force<E>(cell.x, cell.gather(local, j), cell.material);
    if (cell.owned) sums.energies[j] += energy;
    for (int a = 0; a < E::vertices; ++a)
      if (const int v = cell.vertex(a); v < mesh.owned) mesh::at_vertex(sums.forces.col(j), v) += force.col(a);
  }
}

}  // namespace

InternalForces internal_forces(const Problem& problem, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  InternalForces sums{Eigen::VectorXd::Zero(u.cols()), mesh::VertexRows::Zero(u.rows(), u.cols())};
  each_cell(mesh, problem.materials, [&]<class E>(const Cell<E>& cell) { add_cell(mesh, cell, local, sums); });
  parallel::sum_in_place(mesh.comm, sums.energies);
  return sums;
}

}  // namespace ritz::stages
