#include "ritz/stages/assemble.hpp"

#include <utility>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/fem/cell_matrices.hpp"
#include "ritz/stages/each_cell.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"
#include "ritz/stages/sparsity.hpp"

namespace ritz::stages {
namespace {

/// K's rows, filled in place, and one number of M_s for each entry of the vertex graph.
struct Sums {
  BlockRows stiffness;
  std::vector<double> mass;
};

bool own(const mesh::Mesh& mesh, int vertex) { return vertex < mesh.owned; }

void end_row(algebra::Rows& rows) {
  for (algebra::Csr* part : {&rows.own, &rows.other})
    part->starts.push_back(static_cast<PetscInt>(part->columns.size()));
}

void add_cell(Sums& sums, const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Cell& cell) {
  const auto K = fem::stiffness(cell.type, cell.x, cell.material.at_rest());
  const auto M = fem::mass(cell.type, cell.x, cell.material.density);
  for (int a = 0; a < cell.count(); ++a) {
    const int row = cell.vertex(a);
    if (row >= mesh.owned) continue;
    for (int b = 0; b < cell.count(); ++b) {
      const int column = cell.vertex(b);
      const auto place = sums.stiffness.pattern.graph.place(mesh.global, row, column);
      add_block(sums.stiffness.rows, sums.stiffness.pattern, mesh, dofs, place, row, column,
                mesh::at_vertices(K, a, b));
      sums.mass[place] += M(a, b);
    }
  }
}

/// A row of the masses of `row` and its neighbours; number(column): global, or negative where there is none.
template <class Number>
void append_mass(algebra::Rows& rows, const mesh::Mesh& mesh, const Sums& sums, int row, mesh::Index first,
                 Number number) {
  const VertexGraph& graph = sums.stiffness.pattern.graph;
  for (auto p = graph.starts[static_cast<std::size_t>(row)]; p < graph.starts[static_cast<std::size_t>(row) + 1]; ++p) {
    const int column = graph.columns[p];
    const mesh::Index n = number(column);
    if (n < 0) continue;
    algebra::Csr& to = part(rows, mesh, column);
    to.columns.push_back(static_cast<PetscInt>(n - (own(mesh, column) ? first : 0)));
    to.values.push_back(sums.mass[p]);
  }
  end_row(rows);
}

algebra::Rows mass_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Sums& sums) {
  algebra::Rows rows;
  rows.own.columns.reserve(mesh::components * sums.mass.size());
  rows.own.values.reserve(mesh::components * sums.mass.size());
  for (int row = 0; row < mesh.owned; ++row)
    for (int i = 0; i < mesh::components; ++i)
      if (!dofs.fixed(row, i))
        append_mass(rows, mesh, sums, row, dofs.first, [&](int column) { return dofs.number(column, i); });
  return rows;
}

algebra::Rows scalar_mass_rows(const mesh::Mesh& mesh, const Sums& sums) {
  algebra::Rows rows;
  rows.own.columns.reserve(sums.mass.size());
  rows.own.values.reserve(sums.mass.size());
  for (int row = 0; row < mesh.owned; ++row)
    append_mass(rows, mesh, sums, row, mesh.first,
                [&](int column) { return mesh.global[static_cast<std::size_t>(column)]; });
  return rows;
}

/// Squares and quotients of numbers beyond these leave double precision, and what is made of them has no digits.
void refuse_extremes(const Matrices& matrices) {
  constexpr double least = 1e-120, most = 1e120;
  const double stiffness = algebra::one_norm(matrices.stiffness), mass = algebra::one_norm(matrices.scalar_mass);
  for (const double value : {stiffness, mass, stiffness / mass})
    if (!(value >= least && value <= most))
      throw NumericalError("the stiffness and the mass of the body, of the order of " + shown(stiffness, 3) +
                               " N/m and " + shown(mass, 3) + " kg, are beyond what double precision can compute with",
                           Reason::beyond_double_precision);
}

}  // namespace

Problem assemble(mesh::Mesh mesh, mesh::Dofs dofs, fem::Materials materials) {
  Sums sums{empty_rows(mesh, dofs), {}};
  sums.mass.assign(sums.stiffness.pattern.graph.columns.size(), 0);
  each_cell(mesh, materials, [&](const Cell& cell) { add_cell(sums, mesh, dofs, cell); });
  const auto positive = algebra::Definite::positive;
  Matrices matrices;
  matrices.stiffness =
      algebra::symmetric_matrix(mesh.comm, std::move(sums.stiffness.rows), dofs.block, algebra::Definite::semi);
  matrices.mass = algebra::symmetric_matrix(mesh.comm, mass_rows(mesh, dofs, sums), dofs.block, positive);
  matrices.scalar_mass = algebra::symmetric_matrix(mesh.comm, scalar_mass_rows(mesh, sums), 1, positive);
  refuse_extremes(matrices);
  return {std::move(mesh), std::move(dofs), std::move(materials), std::move(matrices)};
}

}  // namespace ritz::stages
