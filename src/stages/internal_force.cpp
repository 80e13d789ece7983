#include "ritz/stages/internal_force.hpp"

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/stvk.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {
namespace {

template <class E>
void add_cell(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const petsc::Tall& local,
              InternalForces& sums) {
  const auto vertices = mesh.cells.of(cell);
  const fem::Coordinates<E> x = mesh.corners(cell);
  for (Eigen::Index j = 0; j < local.cols(); ++j) {
    fem::Coordinates<E> u;
    for (int a = 0; a < E::vertices; ++a)
      u.col(a) = local.col(j).template segment<3>(3 * vertices[static_cast<std::size_t>(a)]);
    const auto [energy, force] = fem::energy_and_force<E>(x, u, material);
    if (cell < mesh.cells.owned) sums.energies[j] += energy;
    for (int a = 0; a < E::vertices; ++a)
      if (const int v = vertices[static_cast<std::size_t>(a)]; v < mesh.owned)
        sums.forces.col(j).template segment<3>(3 * v) += force.col(a);
  }
}

}  // namespace

InternalForces internal_forces(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials,
                               const petsc::ConstTallRef& u) {
  const petsc::Tall local = mesh::with_ghosts(mesh, u);
  InternalForces sums{Eigen::VectorXd::Zero(u.cols()), petsc::Tall::Zero(u.rows(), u.cols())};
  for (const int c : file_order(mesh.cells)) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_cell<E>(mesh, c, material, local, sums); });
  }
  parallel::sum_in_place(mesh.comm, sums.energies);
  return sums;
}

}  // namespace ritz::stages
