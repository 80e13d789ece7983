// Loops over the cells of this rank. The kernel gets the element type, material and vertices of each cell; nothing is
// allocated.
#pragma once
#include <span>

#include "ritz/fem/material.hpp"
#include "ritz/fem/types.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/rows.hpp"

namespace ritz::stages {

struct Cell {
  int number;  ///< local number of the cell
  bool owned;  ///< by this rank; else the cell is in the halo
  fem::CellType type;
  std::span<const int> vertices;  ///< local numbers
  int region;                     ///< of the mesh
  const fem::Material& material;
  fem::CellVectors x;  ///< of the vertices at rest, m, one column for each

  int count() const { return static_cast<int>(vertices.size()); }
  int vertex(int a) const { return vertices[static_cast<std::size_t>(a)]; }

  /// The values of column `j` of `local`, 3 x vertices; the rows of `local` are those of all local vertices, 3 for
  /// each.
  fem::CellVectors gather(mesh::LocalRef local, Eigen::Index j) const {
    fem::CellVectors u(3, count());
    for (int a = 0; a < count(); ++a) u.col(a) = mesh::at_vertex(local.col(j), vertex(a));
    return u;
  }
};

inline Cell cell_of(const mesh::Mesh& mesh, const fem::Materials& materials, int cell) {
  const auto c = static_cast<std::size_t>(cell);
  const auto vertices = mesh.cells.of(cell);
  const auto region = mesh.cells.regions[c];
  Cell view{cell,
            cell < mesh.cells.owned,
            mesh.cells.types[c],
            vertices,
            static_cast<int>(region),
            materials[static_cast<std::size_t>(region)],
            fem::CellVectors(3, static_cast<int>(vertices.size()))};
  for (int a = 0; a < view.count(); ++a) view.x.col(a) = mesh.points.col(view.vertex(a));
  return view;
}

/// Calls kernel(Cell) for every cell of this rank and of its halo, in the order of the file. Sums over these cells into
/// rows of owned vertices are complete, and are rounded the same on any number of ranks.
template <class Kernel>
void each_cell(const mesh::Mesh& mesh, const fem::Materials& materials, Kernel&& kernel) {
  for (const int c : mesh.cells.file_order) kernel(cell_of(mesh, materials, c));
}

/// Calls kernel(Cell) for the cells that this rank owns, in the order of the file. A sum over these and then over the
/// ranks counts each cell once.
template <class Kernel>
void each_owned_cell(const mesh::Mesh& mesh, const fem::Materials& materials, Kernel&& kernel) {
  for (int c = 0; c < mesh.cells.owned; ++c) kernel(cell_of(mesh, materials, c));
}

}  // namespace ritz::stages
