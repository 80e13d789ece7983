// Meshes made of hexahedra of the integer lattice: beams, balls, bodies that touch in a vertex or an edge.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "ritz/fem/cell.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::test {

using Hexahedron = std::array<int, 3>;  ///< its lowest corner
using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// nx x ny x nz hexahedra from the origin on.
std::vector<Hexahedron> grid(int nx, int ny, int nz);

/// The hexahedra as they are (hex8, hex20), or each cut into 24 tetrahedra around its middle and its faces' middles,
/// which keeps all symmetries of the cube, into two wedges or into six pyramids. Hexahedra share the lattice vertices
/// that they have in common. Every vertex, mid-edge ones too, is put where `map` sends its lattice coordinates. One
/// region, "body".
mesh::FileMesh lattice_mesh(const std::vector<Hexahedron>& hexahedra, fem::CellType type, const Map& map);

/// The ends of a Tet10's edges and the vertex in the middle, by the cell's own numbers.
inline constexpr auto tet10_edges = [] {
  constexpr auto shape = fem::shape(fem::CellType::tet10);
  std::array<std::array<std::size_t, 3>, shape.edges.size()> edges{};
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = shape.edges[e];
    edges[e] = {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(shape.corners) + e};
  }
  return edges;
}();

/// Stretches the lattice box [0, n] to [0, lengths].
Map stretched(const std::array<int, 3>& n, const Eigen::Vector3d& lengths);

}  // namespace ritz::test
