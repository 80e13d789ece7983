#include "ritz/stages/strain_energy.hpp"

#include "ritz/fem/strain.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

/// Adds ∫ ε : C : ε of one cell for each column of `local` (3 rows a local vertex).
template <class E>
void add_cell(const Cell<E>& cell, const mesh::LocalRows& local, Eigen::VectorXd& sums) {
  const fem::Coordinates<E> x = fem::relative<E>(cell.x);
  const auto elastic = cell.material.at_rest();
  const double lambda = elastic.lambda, mu = elastic.mu;
  for (const auto& sample : E::rule) {
    const auto [gradients, weight] = fem::physical_gradients<E>(x, sample);
    for (Eigen::Index j = 0; j < local.cols(); ++j) {
      const Eigen::Matrix3d G = fem::relative<E>(cell.gather(local, j)) * gradients;
      const Eigen::Matrix3d strain = (G + G.transpose()) / 2;
      sums[j] += weight * (lambda * strain.trace() * strain.trace() + 2 * mu * strain.squaredNorm());
    }
  }
}

}  // namespace

Eigen::VectorXd strain_energies(const Problem& problem, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(u.cols());
  each_owned_cell(mesh, problem.materials, [&]<class E>(const Cell<E>& cell) { add_cell(cell, local, sums); });
  parallel::sum_in_place(mesh.comm, sums);
  return sums;
}

}  // namespace ritz::stages
