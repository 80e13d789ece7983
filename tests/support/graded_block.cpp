#include "support/graded_block.hpp"

#include "support/lattice_mesh.hpp"

namespace ritz::test {

mesh::Mesh graded_block(int nx, int ny, int nz) {
  mesh::Mesh mesh =
      box("box:1,.1,.06/" + std::to_string(nx) + "," + std::to_string(ny) + "," + std::to_string(nz) + "/tet10");
  const auto towards_sides = [](double x, double length) {
    const double t = 2 * x / length - 1;
    return length * (1 + t * (1.15 - .15 * t * t)) / 2;
  };
  for (int v = 0; v < mesh.local_vertices(); ++v) {
    auto x = mesh.points.col(v);
    x << x[0] * (1 + 2 * x[0]) / 3, towards_sides(x[1], .1), towards_sides(x[2], .06);
  }
  for (int c = 0; c < mesh.cells.count(); ++c) {
    const auto v = mesh.cells.of(c);
    for (const auto& [a, b, middle] : tet10_edges)
      mesh.points.col(v[middle]) = (mesh.points.col(v[a]) + mesh.points.col(v[b])) / 2;
  }
  return mesh;
}

}  // namespace ritz::test
