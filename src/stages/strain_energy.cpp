#include "ritz/stages/strain_energy.hpp"

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/strain.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

/// Adds ∫ ε : C : ε of one cell for each column of `local` (3 rows a local vertex).
template <class E>
void add_cell(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const petsc::Tall& local,
              Eigen::VectorXd& sums) {
  const auto vertices = mesh.cells.of(cell);
  const fem::Coordinates<E> x = fem::relative<E>(fem::Coordinates<E>(mesh.corners(cell)));
  const double lambda = material.lambda(), mu = material.mu();
  for (const auto& sample : E::rule) {
    const auto [gradients, weight] = fem::physical_gradients<E>(x, sample);
    for (Eigen::Index j = 0; j < local.cols(); ++j) {
      fem::Coordinates<E> u;
      for (int a = 0; a < E::vertices; ++a)
        u.col(a) = local.col(j).template segment<3>(3 * vertices[static_cast<std::size_t>(a)]);
      const Eigen::Matrix3d G = fem::relative<E>(u) * gradients;
      const Eigen::Matrix3d strain = (G + G.transpose()) / 2;
      sums[j] += weight * (lambda * strain.trace() * strain.trace() + 2 * mu * strain.squaredNorm());
    }
  }
}

}  // namespace

Eigen::VectorXd strain_energies(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials,
                                const petsc::ConstTallRef& u) {
  const petsc::Tall local = mesh::with_ghosts(mesh, u);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(u.cols());
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_cell<E>(mesh, c, material, local, sums); });
  }
  parallel::sum_in_place(mesh.comm, sums);
  return sums;
}

}  // namespace ritz::stages
