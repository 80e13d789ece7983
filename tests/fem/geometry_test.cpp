// Volumes, inverted cells, slivers and edges.
#include "ritz/fem/geometry.hpp"

#include <cmath>

#include "fem/sample_cells.hpp"

namespace ritz::fem::testing {
namespace {

struct Geometry : ::testing::TestWithParam<CellType> {
  CellType type = GetParam();
};
INSTANTIATE_TEST_SUITE_P(, Geometry, every_cell(), cell_name);

double reference_volume(CellType type) {
  switch (shape(type).linear) {
    case CellType::tet4: return 1. / 6;
    case CellType::wedge6: return 1;
    case CellType::pyramid5: return 4. / 3;
    default: return 8;
  }
}

TEST_P(Geometry, AffineCellHasTheDeterminantsVolume) {
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + random_matrix<3, 3>(1);
  const auto x = mapped(A, reference_cell(type));
  EXPECT_NEAR(volume(type, x), A.determinant() * reference_volume(type), 1e-13);
  EXPECT_NEAR(smallest_jacobian(type, x), A.determinant(), 1e-13);
}

TEST_P(Geometry, CurvedVolumeIsTheFineQuadrature) {
  const auto x = curved_cell(type, 2);
  const double fine = integrate_finely(type, [&](const Point<3>& xi) { return jacobian(type, x, xi); });
  EXPECT_NEAR(volume(type, x), fine, 1e-13 * fine);
}

TEST_P(Geometry, MirroredCellIsInverted) {
  auto x = curved_cell(type, 3);
  EXPECT_GT(smallest_jacobian(type, x), 0);
  x.row(0) *= -1;
  EXPECT_LT(smallest_jacobian(type, x), 0);
  EXPECT_LT(volume(type, x), 0);
}

TEST_P(Geometry, ADisplacementThatMirrorsTurnsInsideOut) {
  const auto x = curved_cell(type, 5);
  const auto turned = [&](const Matrix<3, 3>& A) {
    return turned_inside_out(type, x, mapped(A - Matrix<3, 3>::Identity(), x));
  };
  const Matrix<3, 3> turn = Eigen::AngleAxisd(3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_FALSE(turned(turn));
  EXPECT_FALSE(turned(Eigen::Vector3d(1, 1, 1e-3).asDiagonal()));
  EXPECT_TRUE(turned(Eigen::Vector3d(1, 1, -1e-3).asDiagonal()));
  EXPECT_TRUE(turned(turn * Eigen::Vector3d(1, -1, 1).asDiagonal()));
}

TEST_P(Geometry, LosesNothingFarFromTheOrigin) {
  const auto x = rounded(curved_cell(type, 4));
  const auto far = far_away(x);
  EXPECT_EQ(volume(type, x), volume(type, far));
  EXPECT_EQ(smallest_jacobian(type, x), smallest_jacobian(type, far));
  EXPECT_EQ(shortest_edge(type, x), shortest_edge(type, far));
}

TEST(SmallestJacobian, FindsCellsFoldedAtOneVertex) {
  auto tet = reference_cell(CellType::tet10);
  tet(0, 4) = .2;  // short of the quarter point: the map folds at corner 0
  EXPECT_LT(smallest_jacobian(CellType::tet10, tet), 0);
  EXPECT_GT(volume(CellType::tet10, tet), 0);
  auto hex = reference_cell(CellType::hex8);
  hex.col(6) << -.5, -.5, -.5;  // a corner pushed through the opposite diagonal plane
  EXPECT_LT(smallest_jacobian(CellType::hex8, hex), 0);
  EXPECT_GT(volume(CellType::hex8, hex), 0);
}

TEST(SmallestJacobian, OfAFlatCellIsZero) {
  auto x = reference_cell(CellType::tet4);
  x.row(2).setZero();
  EXPECT_EQ(smallest_jacobian(CellType::tet4, x), 0);
}

TEST(ShortestEdge, IsTheShortestOfTheEdgesOnly) {
  EXPECT_DOUBLE_EQ(shortest_edge(CellType::tet4, reference_cell(CellType::tet4)), 1);
  EXPECT_DOUBLE_EQ(shortest_edge(CellType::tet10, reference_cell(CellType::tet10)), 1);
  const auto flat = mapped(Vector<3>(1, 2, .25).asDiagonal(), reference_cell(CellType::hex8));
  EXPECT_DOUBLE_EQ(shortest_edge(CellType::hex8, flat), .5);
}

/// Along each edge: the angle between the two other corners seen along the edge.
double dihedral_by_projection(const CellVectors& x) {
  double smallest = 180;
  for (const auto& [i, j] : shape(CellType::tet4).edges) {
    std::array<Vector<3>, 2> side;
    const Vector<3> along = (x.col(j) - x.col(i)).normalized();
    int n = 0;
    for (int k = 0; k < 4; ++k) {
      if (k == i || k == j) continue;
      const Vector<3> out = x.col(k) - x.col(i);
      side[n++] = (out - out.dot(along) * along).normalized();
    }
    smallest = std::min(smallest, std::acos(side[0].dot(side[1])) * 180 / M_PI);
  }
  return smallest;
}

TEST(SmallestDihedral, OfKnownTetrahedra) {
  CellVectors regular(3, 4);
  regular << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  EXPECT_NEAR(smallest_dihedral(regular), 70.528779365509308, 1e-12);
  EXPECT_NEAR(smallest_dihedral(reference_cell(CellType::tet4)), 54.735610317245346, 1e-12);
  EXPECT_NEAR(smallest_dihedral(reference_cell(CellType::tet10)), 54.735610317245346, 1e-12);
}

TEST(SmallestDihedral, IsTheAngleSeenAlongTheEdges) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CellVectors x = random_matrix<3, 4>(seed);
    EXPECT_NEAR(smallest_dihedral(x), dihedral_by_projection(x), 1e-9);
    x.row(1) *= -1;
    EXPECT_NEAR(smallest_dihedral(x), dihedral_by_projection(x), 1e-9);
  }
}

TEST(SmallestDihedral, OfASliverKeepsItsDigits) {
  const double h = 1e-9;  // two crossing edges 2h apart: the angle is 2 √2 h
  CellVectors sliver(3, 4);
  sliver << -1, 1, 0, 0, 0, 0, -1, 1, h, h, -h, -h;
  const double expected = 2 * std::sqrt(2.) * h * 180 / M_PI;
  EXPECT_NEAR(smallest_dihedral(sliver), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace ritz::fem::testing
