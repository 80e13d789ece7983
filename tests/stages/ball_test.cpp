// The free ball with ν = .25 against Lamb's solution: ωR/c_s and multiplicities, by curved quadratic tetrahedra.
#include <gtest/gtest.h>

#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

constexpr int n = 5;  ///< hexahedra of 24 Tet10 a diameter
constexpr double radius = .3;

/// The cube [0, n]³ onto the ball: smooth, and its surface onto the sphere.
Eigen::Vector3d onto_ball(const Eigen::Vector3d& lattice) {
  const Eigen::Array3d x = 2 * lattice.array() / n - 1, s = x.square();
  const Eigen::Array3d y(s[1], s[2], s[0]), z(s[2], s[0], s[1]);
  return radius * (x * (1 - y / 2 - z / 2 + y * z / 3).sqrt()).matrix();
}

/// Only edges on the sphere are curved: where two faces of the cube meet, the map has folded them into one plane, and
/// curved edges that run inwards from there would turn cells inside out.
void straighten_inner_edges(mesh::FileMesh& mesh) {
  const auto point = [&](mesh::Index v) {
    return Eigen::Map<Eigen::Vector3d>(mesh.points[static_cast<std::size_t>(v)].data());
  };
  const auto inside = [&](mesh::Index v) { return point(v).norm() < radius * (1 - 1e-9); };
  for (std::size_t cell = 0; cell < mesh.cell_types.size(); ++cell)
    for (const auto& [a, b, middle] : tet10_edges) {
      const auto* v = &mesh.cell_vertices[10 * cell];
      if (inside(v[a]) || inside(v[b])) point(v[middle]) = (point(v[a]) + point(v[b])) / 2;
    }
}

TEST(Ball, HasLambsFrequenciesAndMultiplicities) {
  const fem::Material material = test::stvk(1e6, .25, 1000);
  auto mesh = lattice_mesh(grid(n, n, n), fem::CellType::tet10, onto_ball);
  straighten_inner_edges(mesh);
  const auto result = modes(problem(distributed(mesh), {}, {material}), 28);
  EXPECT_EQ(rigid_count(result.modes), 6);
  const Eigen::VectorXd omega =
      flexible(result.modes).cwiseSqrt() * radius / std::sqrt(material.at_rest().mu / material.density);
  ASSERT_GE(omega.size(), 28);
  Eigen::Index i = 0;
  for (const auto& [expected, times] :
       {std::pair{2.501133, 5}, {2.639869, 5}, {3.424530, 3}, {3.864700, 7}, {3.916337, 7}, {4.439998, 1}})
    for (const auto end = i + times; i < end; ++i) EXPECT_NEAR(omega[i] / expected, 1, .002) << "mode " << i + 1;
}

}  // namespace
}  // namespace ritz::test
