// A file mesh of a few cells of any types, written out.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::test {

struct ListedCell {
  fem::CellType type;
  std::vector<mesh::Index> vertices;  ///< positions
};

using Points = std::vector<std::array<double, 3>>;

/// One region, no sets; vertices and cells are numbered from 1.
inline mesh::FileMesh listed_mesh(const Points& points, const std::vector<ListedCell>& cells) {
  mesh::FileMesh mesh;
  mesh.points = points;
  mesh.regions = {{"body", std::nullopt}};
  for (std::size_t v = 0; v < points.size(); ++v) mesh.vertex_ids.push_back(static_cast<mesh::Index>(v) + 1);
  for (const auto& cell : cells) {
    mesh.cell_types.push_back(cell.type);
    mesh.cell_ids.push_back(std::ssize(mesh.cell_types));
    mesh.cell_regions.push_back(0);
    mesh.cell_vertices.insert(mesh.cell_vertices.end(), cell.vertices.begin(), cell.vertices.end());
    mesh.cell_offsets.push_back(std::ssize(mesh.cell_vertices));
  }
  return mesh;
}

/// A unit cube of one Hex8 under a pyramid of two Tet4, cut along the diagonal 4-6 of the cube's top or along 5-7.
enum class Diagonal { from_4_to_6, from_5_to_7 };

inline mesh::FileMesh cube_with_cap(Diagonal diagonal) {
  const bool even = diagonal == Diagonal::from_4_to_6;
  return listed_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {.5, .5, 2}},
      {{fem::CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7}},
       {fem::CellType::tet4, even ? std::vector<mesh::Index>{4, 5, 6, 8} : std::vector<mesh::Index>{4, 5, 7, 8}},
       {fem::CellType::tet4, even ? std::vector<mesh::Index>{4, 6, 7, 8} : std::vector<mesh::Index>{5, 6, 7, 8}}});
}

}  // namespace ritz::test
