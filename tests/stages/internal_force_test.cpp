// The patch test: a body that is strained evenly is in equilibrium wherever it is not held.
#include "ritz/stages/internal_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ritz/parallel/comm.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

class Patch : public testing::TestWithParam<const char*> {
 protected:
  Patch() {
    // Corners out of line; edges stay straight.
    const Eigen::Matrix3Xd regular = mesh.points;
    for (int c = 0; c < mesh.cells.count(); ++c) {
      const auto vertices = mesh.cells.of(c);
      const auto moved = [&](int a) -> Eigen::Vector3d {
        const Eigen::Vector3d x = regular.col(vertices[static_cast<std::size_t>(a)]);
        return x +
               .04 * Eigen::Vector3d(std::sin(17 * x.y() + 5 * x.z()), std::sin(13 * x.x()), std::cos(11 * x.sum()));
      };
      for (std::size_t a = 0; a < vertices.size(); ++a) mesh.points.col(vertices[a]) = moved(static_cast<int>(a));
      const auto cell = fem::shape(mesh.cells.types[static_cast<std::size_t>(c)]);
      if (!cell.quadratic()) continue;
      for (int e = 0; e < std::ssize(cell.edges); ++e) {
        const auto [a, b] = cell.edges[static_cast<std::size_t>(e)];
        mesh.points.col(vertices[static_cast<std::size_t>(cell.corners + e)]) = (moved(a) + moved(b)) / 2;
      }
    }
  }

  /// Owned vertices that are on no boundary face.
  std::vector<int> inner() const {
    std::set<int> outer;
    for (const auto* name : {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"})
      for (const int v : mesh.find(name)->vertices) outer.insert(v);
    std::vector<int> found;
    for (int v = 0; v < mesh.owned; ++v)
      if (!outer.contains(v)) found.push_back(v);
    return found;
  }

  Problem body = problem(box(std::string("box:1,.8,.9/4,3,3/") + GetParam()), {}, {test::stvk(1e5, .3, 1000)});
  mesh::Mesh& mesh = body.mesh;
};

TEST_P(Patch, InnerVerticesFeelNoForce) {
  const double E = body.materials[0].at_rest().young();
  Eigen::Matrix3d gradient;
  gradient << .3, -.2, .1, .15, -.25, .05, -.1, .2, .4;
  algebra::Tall u(3 * mesh.owned, 1);
  for (int v = 0; v < mesh.owned; ++v) u.col(0).segment<3>(3 * v) = gradient * mesh.points.col(v);
  const auto result = stages::internal_forces(body.mesh, body.materials, u);
  for (const int v : inner()) EXPECT_LE(result.forces.col(0).segment<3>(3 * v).norm(), 1e-13 * E) << v;
  double largest = 0;
  for (int v = 0; v < mesh.owned; ++v) largest = std::max(largest, result.forces.col(0).segment<3>(3 * v).norm());
  EXPECT_GT(parallel::max(mesh.comm, largest), 1e-3 * E);
}

INSTANTIATE_TEST_SUITE_P(Cells, Patch, testing::Values("tet4", "tet10", "hex8", "hex20", "wedge6", "wedge15"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace ritz::test
