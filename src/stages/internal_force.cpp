#include "ritz/stages/internal_force.hpp"

#include <algorithm>
#include <utility>

#include "ritz/fem/response.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/strain.hpp"

namespace ritz::stages {
namespace {

void add_force(const mesh::Mesh& mesh, const Cell& cell, const mesh::LocalRows& local, InternalForces& sums) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  for (Eigen::Index j = 0; j < local.cols(); ++j) {
    const auto [energy, force] = fem::energy_and_force(points, cell.gather(local, j), cell.material);
    if (cell.owned) sums.energies[j] += energy;
    for (int a = 0; a < cell.count(); ++a)
      if (const int v = cell.vertex(a); v < mesh.owned) mesh::at_vertex(sums.forces.col(j), v) += force.col(a);
  }
}

/// Where a cell's sums go.
struct Target {
  const BlockPattern& pattern;
  algebra::Rows& rows;
  const mesh::Mesh& mesh;
  const mesh::Dofs& dofs;
};

void add_tangent(const Target& to, const Cell& cell, const Eigen::VectorXd& weights, const mesh::LocalRows& local) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  fem::TangentSum sum(points);
  for (Eigen::Index j = 0; j < weights.size(); ++j) sum.add(cell.gather(local, j), cell.material, weights[j]);
  const auto K = sum.matrix();
  for (int a = 0; a < cell.count(); ++a) {
    const int row = cell.vertex(a);
    if (row >= to.mesh.owned) continue;
    for (int b = 0; b < cell.count(); ++b) {
      const int column = cell.vertex(b);
      const auto place = to.pattern.graph.place(to.mesh.global, row, column);
      add_block(to.rows, to.pattern, to.mesh, to.dofs, place, row, column, mesh::at_vertices(K, a, b));
    }
  }
}

/// Adds ∫ ε : C : ε of one cell for each column of `local` (3 rows a local vertex).
void add_strain_energy(const Cell& cell, const mesh::LocalRows& local, Eigen::VectorXd& sums) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  const fem::Matrix<6, 6> C = cell.material.at_rest().hooke();
  for (Eigen::Index j = 0; j < local.cols(); ++j) {
    const fem::CellVectors u = cell.gather(local, j);
    for (int q = 0; q < points.count(); ++q)
      sums[j] += points.weight(q) * twice_energy(C, strain(u, points.gradients(q)));
  }
}

}  // namespace

InternalForces internal_forces(const mesh::Mesh& mesh, const fem::Materials& materials, mesh::VertexRef u) {
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  InternalForces sums{Eigen::VectorXd::Zero(u.cols()), mesh::VertexRows::Zero(u.rows(), u.cols())};
  each_cell(mesh, materials, [&](const Cell& cell) { add_force(mesh, cell, local, sums); });
  parallel::sum_in_place(mesh.comm, sums.energies);
  return sums;
}

Tangent empty_tangent(const Problem& problem) {
  BlockRows blocks = empty_rows(problem.mesh, problem.dofs);
  return {std::move(blocks.pattern), algebra::symmetric_matrix(problem.mesh.comm, std::move(blocks.rows),
                                                               problem.dofs.block, algebra::Definite::semi)};
}

void fill_tangent(Tangent& tangent, const Problem& problem, const Eigen::VectorXd& weights, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  algebra::Rows& rows = algebra::storage(tangent.matrix);
  for (algebra::Csr* part : {&rows.own, &rows.other}) std::fill(part->values.begin(), part->values.end(), 0.0);
  const Target to{tangent.pattern, rows, mesh, problem.dofs};
  each_cell(mesh, problem.materials, [&](const Cell& cell) { add_tangent(to, cell, weights, local); });
  algebra::renewed(tangent.matrix);
}

Eigen::VectorXd strain_energies(const Problem& problem, mesh::VertexRef u) {
  const mesh::Mesh& mesh = problem.mesh;
  const mesh::LocalRows local = mesh::with_ghosts(mesh, u, mesh::components);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(u.cols());
  each_owned_cell(mesh, problem.materials, [&](const Cell& cell) { add_strain_energy(cell, local, sums); });
  parallel::sum_in_place(mesh.comm, sums);
  return sums;
}

}  // namespace ritz::stages
