#include "support/lattice_mesh.hpp"

#include <map>

namespace ritz::test {
namespace {

constexpr int steps = 4;  ///< of the fine lattice in a hexahedron's edge: mid-edge vertices are on it too
using Fine = std::array<int, 3>;

Fine sum(const Fine& a, const Fine& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Fine half(const Fine& a) { return {a[0] / 2, a[1] / 2, a[2] / 2}; }
Fine middle(const Fine& a, const Fine& b) { return half(sum(a, b)); }

std::vector<Fine> corners(const Hexahedron& h) {
  const int bottom[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Fine> all;
  for (int k = 0; k < 2; ++k)
    for (const auto& [i, j] : bottom) all.push_back({steps * (h[0] + i), steps * (h[1] + j), steps * (h[2] + k)});
  return all;
}

/// Corners of the 24 tetrahedra: an edge of a face, the face's middle, the hexahedron's middle.
std::vector<std::vector<Fine>> tetrahedra(const std::vector<Fine>& hexahedron) {
  std::vector<std::vector<Fine>> tets;
  const Fine centre = middle(hexahedron[0], hexahedron[6]);
  const auto at = [&](int v) { return hexahedron[static_cast<std::size_t>(v)]; };
  for (const auto& side : fem::shape(fem::CellType::hex8).faces) {
    const auto face = side.corners();
    for (std::size_t e = 0; e < 4; ++e)
      tets.push_back({at(face[(e + 1) % 4]), at(face[e]), middle(at(face[0]), at(face[2])), centre});
  }
  return tets;
}

/// On each face, with the hexahedron's middle as their apex.
std::vector<std::vector<Fine>> pyramids(const std::vector<Fine>& hexahedron) {
  std::vector<std::vector<Fine>> all;
  for (const auto& side : fem::shape(fem::CellType::hex8).faces) {
    std::vector<Fine> cell;
    for (const int v : side.corners()) cell.insert(cell.begin(), hexahedron[static_cast<std::size_t>(v)]);
    cell.push_back(middle(hexahedron[0], hexahedron[6]));
    all.push_back(cell);
  }
  return all;
}

std::vector<std::vector<Fine>> wedges(const std::vector<Fine>& h) {
  return {{h[4], h[5], h[6], h[0], h[1], h[2]}, {h[4], h[6], h[7], h[0], h[2], h[3]}};
}

std::vector<std::vector<Fine>> cells_of(const std::vector<Fine>& hexahedron, fem::CellType linear) {
  switch (linear) {
    case fem::CellType::hex8: return {hexahedron};
    case fem::CellType::wedge6: return wedges(hexahedron);
    case fem::CellType::pyramid5: return pyramids(hexahedron);
    default: return tetrahedra(hexahedron);
  }
}

std::vector<Fine> with_middles(std::vector<Fine> c, fem::CellType type) {
  if (fem::shape(type).quadratic())
    for (const auto& [a, b] : fem::shape(type).edges)
      c.push_back(middle(c[static_cast<std::size_t>(a)], c[static_cast<std::size_t>(b)]));
  return c;
}

}  // namespace

std::vector<Hexahedron> grid(int nx, int ny, int nz) {
  std::vector<Hexahedron> all;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) all.push_back({i, j, k});
  return all;
}

mesh::FileMesh lattice_mesh(const std::vector<Hexahedron>& hexahedra, fem::CellType type, const Map& map) {
  mesh::FileMesh mesh;
  mesh.regions = {{"body", std::nullopt}};
  std::map<Fine, mesh::Index> numbers;
  const auto number = [&](const Fine& v) {
    const auto [place, is_new] = numbers.try_emplace(v, static_cast<mesh::Index>(mesh.points.size()));
    if (is_new) {
      const Eigen::Vector3d x = map(Eigen::Vector3d(v[0], v[1], v[2]) / steps);
      mesh.points.push_back({x.x(), x.y(), x.z()});
      mesh.vertex_ids.push_back(place->second + 1);
    }
    return place->second;
  };
  for (const auto& h : hexahedra) {
    for (const auto& cell : cells_of(corners(h), fem::shape(type).linear)) {
      for (const auto& v : with_middles(cell, type)) mesh.cell_vertices.push_back(number(v));
      mesh.cell_offsets.push_back(static_cast<mesh::Index>(mesh.cell_vertices.size()));
      mesh.cell_types.push_back(type);
      mesh.cell_ids.push_back(static_cast<mesh::Index>(mesh.cell_types.size()));
      mesh.cell_regions.push_back(0);
    }
  }
  return mesh;
}

Map stretched(const std::array<int, 3>& n, const Eigen::Vector3d& lengths) {
  return [=](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return {lengths.x() * x.x() / n[0], lengths.y() * x.y() / n[1], lengths.z() * x.z() / n[2]};
  };
}

}  // namespace ritz::test
