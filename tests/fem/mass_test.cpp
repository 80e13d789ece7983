// The consistent mass against fine quadrature, its sums and invariances.
#include "ritz/fem/mass.hpp"

#include <Eigen/Cholesky>

#include "fem/sample_cells.hpp"
#include "ritz/fem/geometry.hpp"
#include "support/dense_algebra.hpp"

namespace ritz::fem::testing {
namespace {

constexpr double density = 3.7;

template <class E>
struct Mass : ::testing::Test {};
TYPED_TEST_SUITE(Mass, Elements);

template <class E>
Eigen::MatrixXd mass_of(const Coordinates<E>& x) {
  return any_size(mass<E>(x, density));
}

template <class E>
Eigen::MatrixXd fine_mass(const Coordinates<E>& x) {
  return integrate_finely<E>([&](const Point<3>& xi) -> Eigen::MatrixXd {
    const Eigen::MatrixXd N = any_size(E::shape(xi));
    return density * jacobian<E>(x, xi).determinant() * N * N.transpose();
  });
}

TYPED_TEST(Mass, IsTheFineQuadratureOnStraightAndCurvedCells) {
  using E = TypeParam;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const auto& x : {straight_cell<E>(seed), curved_cell<E>(seed)}) {
      const Eigen::MatrixXd expected = fine_mass<E>(x);
      EXPECT_LT((mass_of<E>(x) - expected).norm(), 1e-13 * expected.norm());
    }
}

TYPED_TEST(Mass, IsExactlySymmetricAndPositiveDefinite) {
  for (const auto& x : {straight_cell<TypeParam>(8), curved_cell<TypeParam>(8)}) {
    const auto M = mass_of<TypeParam>(x);
    EXPECT_EQ(M, Eigen::MatrixXd(M.transpose()));
    EXPECT_GT(test::symmetric_eigenvalues(M).minCoeff(), 0);
  }
}

TYPED_TEST(Mass, SumsToVolumeTimesDensity) {
  const auto x = curved_cell<TypeParam>(9);
  EXPECT_NEAR(mass_of<TypeParam>(x).sum(), density * volume<TypeParam>(x), 1e-13 * volume<TypeParam>(x));
}

TYPED_TEST(Mass, IsUnchangedByRotationAndFarFromTheOrigin) {
  using E = TypeParam;
  for (const auto& cell : {straight_cell<E>(10), curved_cell<E>(10)}) {
    const auto x = rounded<E>(cell);
    const auto M = mass_of<E>(x);
    EXPECT_EQ(M, mass_of<E>(far_away<E>(x)));
    EXPECT_LT((mass_of<E>(mapped<E>(rotation(), x)) - M).norm(), 1e-14 * M.norm());
  }
}

TEST(Tet10Mass, RowsOfAStraightCellSplitTheMass) {
  const auto x = straight_cell<Tet10>(11);
  const double m = density * volume<Tet10>(x);
  const Eigen::VectorXd rows = mass_of<Tet10>(x).rowwise().sum();
  for (int a = 0; a < 10; ++a) EXPECT_NEAR(rows[a], a < 4 ? -m / 20 : m / 5, 1e-14 * m);
}

TEST(Tet10Mass, ClosedFormIsTheQuadrature) {
  const auto x = straight_cell<Tet10>(12);
  ASSERT_TRUE(straight(x));
  const auto expected = any_size(mass_by_quadrature<Tet10>(x, density));
  EXPECT_LT((mass_of<Tet10>(x) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Tet10Mass, TellsAlmostStraightFromStraight) {
  auto x = straight_cell<Tet10>(13);
  EXPECT_TRUE(straight(x));
  x(1, 7) += 1e-13;
  EXPECT_FALSE(straight(x));
}

TEST(Tet4Mass, IsTwoOneOverTwenty) {
  const auto M = any_size(mass<Tet4>(reference_cell<Tet4>(), 120));
  EXPECT_EQ(M, Eigen::MatrixXd(Eigen::MatrixXd::Ones(4, 4) + Eigen::MatrixXd::Identity(4, 4)));
}

}  // namespace
}  // namespace ritz::fem::testing
