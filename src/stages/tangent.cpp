#include "ritz/stages/tangent.hpp"

#include <algorithm>
#include <utility>

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/stvk.hpp"
#include "ritz/mesh/halo.hpp"

namespace ritz::stages {
namespace {

/// Where a cell's sums go.
struct Target {
  const BlockPattern& pattern;
  petsc::Rows& rows;
  const mesh::Mesh& mesh;
  const mesh::Dofs& dofs;
};

template <class E>
auto weighted_tangent(const mesh::Mesh& mesh, int cell, const fem::StVK& material, const Eigen::VectorXd& weights,
                      const petsc::Tall& local) {
  const auto vertices = mesh.cells.of(cell);
  const fem::Coordinates<E> x = mesh.corners(cell);
  fem::Matrix<3 * E::vertices, 3 * E::vertices> K;
  K.setZero();
  for (Eigen::Index j = 0; j < weights.size(); ++j) {
    fem::Coordinates<E> u;
    for (int a = 0; a < E::vertices; ++a)
      u.col(a) = local.col(j).template segment<3>(3 * vertices[static_cast<std::size_t>(a)]);
    K += weights[j] * fem::tangent<E>(x, u, material);
  }
  return K;
}

template <class E>
void add_cell(const Target& to, int cell, const fem::StVK& material, const Eigen::VectorXd& weights,
              const petsc::Tall& local) {
  const auto vertices = to.mesh.cells.of(cell);
  const auto K = weighted_tangent<E>(to.mesh, cell, material, weights, local);
  for (int a = 0; a < E::vertices; ++a) {
    const int row = vertices[static_cast<std::size_t>(a)];
    if (row >= to.mesh.owned) continue;
    for (int b = 0; b < E::vertices; ++b) {
      const int column = vertices[static_cast<std::size_t>(b)];
      const auto place = to.pattern.graph.place(to.mesh.global, row, column);
      add_block(to.rows, to.pattern, to.mesh, to.dofs, place, row, column, K.template block<3, 3>(3 * a, 3 * b));
    }
  }
}

}  // namespace

Tangent empty_tangent(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  BlockRows blocks = empty_rows(mesh, dofs);
  return {std::move(blocks.pattern),
          petsc::symmetric_matrix(mesh.comm, std::move(blocks.rows), dofs.block, petsc::Definite::semi)};
}

void fill_tangent(Tangent& tangent, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                  const std::vector<fem::StVK>& materials, const Eigen::VectorXd& weights,
                  const petsc::ConstTallRef& u) {
  const petsc::Tall local = mesh::with_ghosts(mesh, u);
  petsc::Rows& rows = petsc::storage(tangent.matrix);
  for (petsc::Csr* part : {&rows.own, &rows.other}) std::fill(part->values.begin(), part->values.end(), 0.0);
  const Target to{tangent.pattern, rows, mesh, dofs};
  for (const int c : file_order(mesh.cells)) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_cell<E>(to, c, material, weights, local); });
  }
  petsc::renewed(tangent.matrix);
}

}  // namespace ritz::stages
