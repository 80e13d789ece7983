// Loops over the cells of this rank. The kernel gets the element type, material and vertices of each cell; nothing is
// allocated.
#pragma once
#include <span>
#include <vector>

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/material.hpp"
#include "ritz/fem/strain.hpp"
#include "ritz/fem/types.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/rows.hpp"

namespace ritz::stages {

/// One cell of element type E.
template <class E>
struct Cell {
  int number;                     ///< local number of the cell
  bool owned;                     ///< by this rank; else the cell is in the halo
  std::span<const int> vertices;  ///< local numbers
  int region;                     ///< of the mesh
  const fem::Material& material;
  fem::Coordinates<E> x;  ///< of the vertices at rest, m, one column for each

  int vertex(int a) const { return vertices[static_cast<std::size_t>(a)]; }

  /// The values of column `j` of `local`, 3 x vertices; the rows of `local` are those of all local vertices, 3 for
  /// each.
  fem::Coordinates<E> gather(mesh::LocalRef local, Eigen::Index j) const {
    fem::Coordinates<E> u;
    for (int a = 0; a < E::vertices; ++a) u.col(a) = mesh::at_vertex(local.col(j), vertex(a));
    return u;
  }
};

/// Calls kernel(Cell<E>) for one cell, where E is its element type, and returns its result.
template <class Kernel>
decltype(auto) visit_cell(const mesh::Mesh& mesh, const fem::Materials& materials, int cell, Kernel&& kernel) {
  const auto c = static_cast<std::size_t>(cell);
  return fem::visit(mesh.cells.types[c], [&]<class E>(E) -> decltype(auto) {
    Cell<E> view{cell,
                 cell < mesh.cells.owned,
                 mesh.cells.of(cell),
                 static_cast<int>(mesh.cells.regions[c]),
                 materials[static_cast<std::size_t>(mesh.cells.regions[c])],
                 {}};
    for (int a = 0; a < E::vertices; ++a) view.x.col(a) = mesh.points.col(view.vertex(a));
    return kernel(std::as_const(view));
  });
}

/// Calls kernel(Cell<E>) for every cell of this rank and of its halo, in the order of the file. Sums over these cells
/// into rows of owned vertices are complete, and are rounded the same on any number of ranks.
template <class Kernel>
void each_cell(const mesh::Mesh& mesh, const fem::Materials& materials, Kernel&& kernel) {
  for (const int c : mesh.cells.file_order) visit_cell(mesh, materials, c, kernel);
}

/// Calls kernel(Cell<E>) for the cells that this rank owns, in the order of the file. A sum over these and then over
/// the ranks counts each cell once.
template <class Kernel>
void each_owned_cell(const mesh::Mesh& mesh, const fem::Materials& materials, Kernel&& kernel) {
  for (int c = 0; c < mesh.cells.owned; ++c) visit_cell(mesh, materials, c, kernel);
}

}  // namespace ritz::stages
