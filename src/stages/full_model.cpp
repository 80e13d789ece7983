#include "ritz/stages/full_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/mesh/halo.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::stages {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <class E>
fem::Coordinates<E> displaced(const mesh::Mesh& mesh, int cell, const petsc::Tall& local) {
  const auto vertices = mesh.cells.of(cell);
  fem::Coordinates<E> u;
  for (int a = 0; a < E::vertices; ++a)
    u.col(a) = local.col(0).template segment<3>(3 * vertices[static_cast<std::size_t>(a)]);
  return u;
}

petsc::Tall local_vertices(const FullModel& model, const petsc::Tall& u) {
  return mesh::with_ghosts(model.mesh, mesh::to_vertices(model.mesh, model.dofs, u));
}

/// ε Σ_q w (λ + 2μ) (1 + ‖∇u‖)² ‖u‖ ‖∇N‖ ‖∇N_a‖ onto each vertex a of a cell that this rank owns.
template <class E>
void add_rounding(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const petsc::Tall& local,
                  Eigen::VectorXd& sums) {
  const auto vertices = mesh.cells.of(cell);
  const fem::Coordinates<E> x = fem::relative<E>(mesh.corners(cell)), u = displaced<E>(mesh, cell, local);
  const double largest = u.cwiseAbs().maxCoeff();
  for (const auto& sample : E::rule) {
    const auto [gradients, weight] = fem::physical_gradients<E>(x, sample);
    const double stretch = 1 + (fem::relative<E>(u) * gradients).norm();
    const double stress =
        epsilon * (material.lambda() + 2 * material.mu()) * stretch * stretch * largest * gradients.norm();
    for (int a = 0; a < E::vertices; ++a)
      if (const int v = vertices[static_cast<std::size_t>(a)]; v < mesh.owned)
        sums[v] += std::abs(weight) * stress * gradients.row(a).norm();
  }
}

}  // namespace

FullModel full_model(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Full& full, petsc::LinearSolver solver) {
  const bool iterative = solver == petsc::LinearSolver::iterative;
  Tangent tangent = empty_tangent(mesh, dofs);
  petsc::Newton newton(tangent.matrix, solver, iterative ? near_null_space(mesh, dofs) : petsc::Tall(dofs.owned, 0));
  return {mesh, dofs, full, std::move(tangent), std::move(newton)};
}

EnergyAndForce energy_and_force(const FullModel& model, const petsc::Tall& u) {
  const auto sums = internal_forces(model.mesh, model.full.materials, mesh::to_vertices(model.mesh, model.dofs, u));
  return {sums.energies[0], mesh::from_vertices(model.mesh, model.dofs, sums.forces)};
}

double force_rounding(const FullModel& model, const petsc::Tall& u) {
  const mesh::Mesh& mesh = model.mesh;
  const petsc::Tall local = local_vertices(model, u);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mesh.owned);
  for (int c = 0; c < mesh.cells.count(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = model.full.materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_rounding<E>(mesh, c, material, local, sums); });
  }
  return std::sqrt(parallel::sum(mesh.comm, sums.squaredNorm()));
}

std::int64_t inverted_cells(const FullModel& model, const petsc::Tall& u) {
  const mesh::Mesh& mesh = model.mesh;
  const petsc::Tall local = local_vertices(model, u);
  std::int64_t inverted = 0;
  for (int c = 0; c < mesh.cells.owned; ++c)
    inverted += fem::visit(mesh.cells.types[static_cast<std::size_t>(c)], [&]<class E>(E) {
      return fem::turned_inside_out<E>(mesh.corners(c), displaced<E>(mesh, c, local));
    });
  return parallel::sum(mesh.comm, inverted);
}

double norm(const FullModel& model, const petsc::Tall& x) { return std::sqrt(dot(model, x, x)); }

double dot(const FullModel& model, const petsc::Tall& x, const petsc::Tall& y) {
  return petsc::inner(model.mesh.comm, x, y)(0, 0);
}

}  // namespace ritz::stages
