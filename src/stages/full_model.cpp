#include "ritz/stages/full_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ritz/fem/element.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::stages {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

mesh::LocalRows local_vertices(const FullModel& model, mesh::FreeRef u) {
  return mesh::with_ghosts(model.problem.mesh, mesh::to_vertices(model.problem.mesh, model.problem.dofs, u),
                           mesh::components);
}

/// ε Σ_q w (λ + 2μ) (1 + ‖∇u‖)² ‖u‖ ‖∇N‖ ‖∇N_a‖ onto each vertex a of a cell that this rank owns.
void add_rounding(const mesh::Mesh& mesh, const Cell& cell, const mesh::LocalRows& local, Eigen::VectorXd& sums) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  const fem::CellVectors u = cell.gather(local, 0), from_first = fem::relative(u);
  const double largest = u.cwiseAbs().maxCoeff();
  const auto elastic = cell.material.at_rest();
  for (int q = 0; q < points.count(); ++q) {
    const auto gradients = points.gradients(q);
    const double stretch = 1 + fem::Matrix<3, 3>(from_first.lazyProduct(gradients)).norm();
    const double stress = epsilon * elastic.stiffest() * stretch * stretch * largest * gradients.norm();
    for (int a = 0; a < cell.count(); ++a)
      if (const int v = cell.vertex(a); v < mesh.owned)
        sums[v] += std::abs(points.weight(q)) * stress * gradients.row(a).norm();
  }
}

}  // namespace

FullModel full_model(const Problem& problem, algebra::LinearSolver solver) {
  const bool iterative = solver == algebra::LinearSolver::iterative;
  Tangent tangent = empty_tangent(problem);
  algebra::Newton newton(
      tangent.matrix, solver,
      iterative ? near_null_space(problem.mesh, problem.dofs) : algebra::Tall(problem.dofs.owned, 0));
  return {problem, std::move(tangent), std::move(newton)};
}

EnergyAndForce energy_and_force(const FullModel& model, mesh::FreeRef u) {
  const auto sums = internal_forces(model.problem.mesh, model.problem.materials,
                                    mesh::to_vertices(model.problem.mesh, model.problem.dofs, u));
  return {sums.energies[0], mesh::from_vertices(model.problem.mesh, model.problem.dofs, sums.forces)};
}

double force_rounding(const FullModel& model, mesh::FreeRef u) {
  const mesh::Mesh& mesh = model.problem.mesh;
  const mesh::LocalRows local = local_vertices(model, u);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mesh.owned);
  each_cell(mesh, model.problem.materials, [&](const Cell& cell) { add_rounding(mesh, cell, local, sums); });
  return std::sqrt(parallel::sum(mesh.comm, sums.squaredNorm()));
}

std::int64_t inverted_cells(const FullModel& model, mesh::FreeRef u) {
  const mesh::LocalRows local = local_vertices(model, u);
  std::int64_t inverted = 0;
  each_owned_cell(model.problem.mesh, model.problem.materials, [&](const Cell& cell) {
    inverted += fem::turned_inside_out(cell.type, cell.x, cell.gather(local, 0));
  });
  return parallel::sum(model.problem.mesh.comm, inverted);
}

double norm(const FullModel& model, mesh::FreeRef x) { return std::sqrt(dot(model, x, x)); }

double dot(const FullModel& model, mesh::FreeRef x, mesh::FreeRef y) {
  return algebra::inner(model.problem.mesh.comm, x, y)(0, 0);
}

}  // namespace ritz::stages
