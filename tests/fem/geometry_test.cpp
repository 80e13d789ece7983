// Volumes, inverted cells, slivers and edges.
#include "ritz/fem/geometry.hpp"

#include <cmath>

#include "fem/sample_cells.hpp"

namespace ritz::fem::testing {
namespace {

template <class E>
struct Geometry : ::testing::Test {};
TYPED_TEST_SUITE(Geometry, Elements);

template <class E>
double reference_volume() {
  return E::type == CellType::hex8 ? 8. : 1. / 6;
}

TYPED_TEST(Geometry, AffineCellHasTheDeterminantsVolume) {
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + random_matrix<3, 3>(1);
  const auto x = mapped<TypeParam>(A, reference_cell<TypeParam>());
  EXPECT_NEAR(volume<TypeParam>(x), A.determinant() * reference_volume<TypeParam>(), 1e-13);
  EXPECT_NEAR(smallest_jacobian<TypeParam>(x), A.determinant(), 1e-13);
}

TYPED_TEST(Geometry, CurvedVolumeIsTheFineQuadrature) {
  using E = TypeParam;
  const auto x = curved_cell<E>(2);
  const double fine = integrate_finely<E>([&](const Point<3>& xi) { return jacobian<E>(x, xi).determinant(); });
  EXPECT_NEAR(volume<E>(x), fine, 1e-13 * fine);
}

TYPED_TEST(Geometry, MirroredCellIsInverted) {
  auto x = curved_cell<TypeParam>(3);
  EXPECT_GT(smallest_jacobian<TypeParam>(x), 0);
  x.row(0) *= -1;
  EXPECT_LT(smallest_jacobian<TypeParam>(x), 0);
  EXPECT_LT(volume<TypeParam>(x), 0);
}

TYPED_TEST(Geometry, ADisplacementThatMirrorsTurnsInsideOut) {
  using E = TypeParam;
  const auto x = curved_cell<E>(5);
  const auto turned = [&](const Matrix<3, 3>& A) {
    return turned_inside_out<E>(x, mapped<E>(A - Matrix<3, 3>::Identity(), x));
  };
  const Matrix<3, 3> turn = Eigen::AngleAxisd(3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_FALSE(turned(turn));
  EXPECT_FALSE(turned(Eigen::Vector3d(1, 1, 1e-3).asDiagonal()));
  EXPECT_TRUE(turned(Eigen::Vector3d(1, 1, -1e-3).asDiagonal()));
  EXPECT_TRUE(turned(turn * Eigen::Vector3d(1, -1, 1).asDiagonal()));
}

TYPED_TEST(Geometry, LosesNothingFarFromTheOrigin) {
  using E = TypeParam;
  const auto x = rounded<E>(curved_cell<E>(4));
  const auto far = far_away<E>(x);
  EXPECT_EQ(volume<E>(x), volume<E>(far));
  EXPECT_EQ(smallest_jacobian<E>(x), smallest_jacobian<E>(far));
  EXPECT_EQ(shortest_edge<E>(x), shortest_edge<E>(far));
}

TEST(SmallestJacobian, FindsCellsFoldedAtOneVertex) {
  auto tet = reference_cell<Tet10>();
  tet(0, 4) = .2;  // short of the quarter point: the map folds at corner 0
  EXPECT_LT(smallest_jacobian<Tet10>(tet), 0);
  EXPECT_GT(volume<Tet10>(tet), 0);
  auto hex = reference_cell<Hex8>();
  hex.col(6) << -.5, -.5, -.5;  // a corner pushed through the opposite diagonal plane
  EXPECT_LT(smallest_jacobian<Hex8>(hex), 0);
  EXPECT_GT(volume<Hex8>(hex), 0);
}

TEST(SmallestJacobian, OfAFlatCellIsZero) {
  auto x = reference_cell<Tet4>();
  x.row(2).setZero();
  EXPECT_EQ(smallest_jacobian<Tet4>(x), 0);
}

TEST(ShortestEdge, IsTheShortestOfTheEdgesOnly) {
  EXPECT_DOUBLE_EQ(shortest_edge<Tet4>(reference_cell<Tet4>()), 1);
  EXPECT_DOUBLE_EQ(shortest_edge<Tet10>(reference_cell<Tet10>()), 1);
  Coordinates<Hex8> flat = Vector<3>(1, 2, .25).asDiagonal() * reference_cell<Hex8>();
  EXPECT_DOUBLE_EQ(shortest_edge<Hex8>(flat), .5);
}

/// Along each edge: the angle between the two other corners seen along the edge.
double dihedral_by_projection(const Coordinates<Tet4>& x) {
  double smallest = 180;
  for (const auto& [i, j] : Tet10::edges) {
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
  Coordinates<Tet4> regular;
  regular << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  EXPECT_NEAR(smallest_dihedral<Tet4>(regular), 70.528779365509308, 1e-12);
  EXPECT_NEAR(smallest_dihedral<Tet4>(reference_cell<Tet4>()), 54.735610317245346, 1e-12);
  EXPECT_NEAR(smallest_dihedral<Tet10>(reference_cell<Tet10>()), 54.735610317245346, 1e-12);
}

TEST(SmallestDihedral, IsTheAngleSeenAlongTheEdges) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Coordinates<Tet4> x = random_matrix<3, 4>(seed);
    EXPECT_NEAR(smallest_dihedral<Tet4>(x), dihedral_by_projection(x), 1e-9);
    x.row(1) *= -1;
    EXPECT_NEAR(smallest_dihedral<Tet4>(x), dihedral_by_projection(x), 1e-9);
  }
}

TEST(SmallestDihedral, OfASliverKeepsItsDigits) {
  const double h = 1e-9;  // two crossing edges 2h apart: the angle is 2 √2 h
  Coordinates<Tet4> sliver;
  sliver << -1, 1, 0, 0, 0, 0, -1, 1, h, h, -h, -h;
  const double expected = 2 * std::sqrt(2.) * h * 180 / M_PI;
  EXPECT_NEAR(smallest_dihedral<Tet4>(sliver), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace ritz::fem::testing
