// Meshes that mix types of cells, and pieces whose vertices other pieces share.
#include <gtest/gtest.h>

#include "support/dense_algebra.hpp"
#include "support/listed_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

mesh::FileMesh tetrahedra(const Points& points, const std::vector<std::vector<mesh::Index>>& cells) {
  std::vector<ListedCell> list;
  for (const auto& vertices : cells) list.push_back({fem::CellType::tet4, vertices});
  return listed_mesh(points, list);
}

int rigid_modes(const mesh::FileMesh& mesh) { return rigid_count(modes(problem(distributed(mesh), {}), 4).modes); }

// The last tetrahedron's vertices belong to earlier pieces, but for one or for none: it swings all the same.
TEST(SharedVertices, LeaveAPieceItsSize) {
  Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  points.insert(points.end(), {{0, -1, -1}, {1, -1, 0}, {0, 2, 1}, {0, 2, 2}, {-1, 2, 2}});
  const std::vector<mesh::Index> last = {0, 1, 2, 3}, at_edge = {0, 4, 1, 5}, at_vertex = {2, 6, 8, 7};
  EXPECT_EQ(rigid_modes(tetrahedra(points, {at_edge, at_vertex, last})), 7 + 3);
  points.insert(points.end(), {{0, 0, 2}, {1, 0, 2}, {0, 1, 3}});
  EXPECT_EQ(rigid_modes(tetrahedra(points, {at_edge, at_vertex, {3, 9, 10, 11}, last})), 7 + 3 + 3);
}

class MixedCells : public testing::TestWithParam<Diagonal> {};

TEST_P(MixedCells, MoveRigidlyInSixWays) {
  const auto file = cube_with_cap(GetParam());
  EXPECT_EQ(rigid_modes(file), 6);
  const Problem p = problem(distributed(file), {});
  EXPECT_EQ(p.mesh.pieces, 1);
  const Eigen::VectorXd expected = dense_modes(p).values;
  const Eigen::VectorXd lambda = flexible(modes(p, 6).modes);
  for (Eigen::Index i = 0; i < lambda.size(); ++i) EXPECT_NEAR(lambda[i] / expected[6 + i], 1, 1e-9);
}

TEST_P(MixedCells, AreHeldByTheirFoot) {
  const Problem p = problem(distributed(cube_with_cap(GetParam())), {fixed_between({-1, -1, -1e-9}, {2, 2, 1e-9})});
  const auto result = modes(p, 6);
  EXPECT_EQ(rigid_count(result.modes), 0);
  const Eigen::VectorXd expected = dense_modes(p).values;
  for (Eigen::Index i = 0; i < 6; ++i) EXPECT_NEAR(result.modes.eigenvalues[i] / expected[i], 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, MixedCells, testing::Values(Diagonal::from_4_to_6, Diagonal::from_5_to_7));

}  // namespace
}  // namespace ritz::test
