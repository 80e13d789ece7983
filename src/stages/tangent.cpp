#include "ritz/stages/tangent.hpp"

#include <algorithm>
#include <utility>

#include "ritz/fem/response.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

/// Where a cell's sums go.
struct Target {
  const BlockPattern& pattern;
  algebra::Rows& rows;
  const mesh::Mesh& mesh;
  const mesh::Dofs& dofs;
};

template <class E>
auto weighted_tangent(const Cell<E>& cell, const Eigen::VectorXd& weights, const mesh::LocalRows& local) {
  fem::Matrix<mesh::components * E::vertices, mesh::components * E::vertices> K;
  K.setZero();
  for (Eigen::Index j = 0; j < weights.size(); ++j)
    K += weights[j] * fem::tangent<E>(cell.x, cell.gather(local, j), cell.material);
  return K;
}

template <class E>
void add_cell(const Target& to, const Cell<E>& cell, const Eigen::VectorXd& weights, const mesh::LocalRows& local) {
  const auto K = weighted_tangent(cell, weights, local);
  for (int a = 0; a < E::vertices; ++a) {
    const int row = cell.vertex(a);
    if (row >= to.mesh.owned) continue;
    for (int b = 0; b < E::vertices; ++b) {
      const int column = cell.vertex(b);
      const auto place = to.pattern.graph.place(to.mesh.global, row, column);
      add_block(to.rows, to.pattern, to.mesh, to.dofs, place, row, column, mesh::at_vertices(K, a, b));
    }
  }
}

}  // namespace

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
  each_cell(mesh, problem.materials, [&]<class E>(const Cell<E>& cell) { add_cell(to, cell, weights, local); });
  algebra::renewed(tangent.matrix);
}

}  // namespace ritz::stages
