// The consistent mass against fine quadrature, its sums and invariances.
#include "ritz/fem/cell_matrices.hpp"

#include <Eigen/Cholesky>

#include "fem/sample_cells.hpp"
#include "ritz/fem/geometry.hpp"
#include "support/dense_algebra.hpp"

namespace ritz::fem::testing {
namespace {

constexpr double density = 3.7;

struct Mass : ::testing::TestWithParam<CellType> {
  CellType type = GetParam();
};
INSTANTIATE_TEST_SUITE_P(, Mass, every_cell(), cell_name);

Eigen::MatrixXd mass_of(CellType type, const CellVectors& x) { return mass(type, x, density); }

Eigen::MatrixXd fine_mass(CellType type, const CellVectors& x) {
  return integrate_finely(type, [&](const Point<3>& xi) -> Eigen::MatrixXd {
    const Eigen::MatrixXd N = shape_functions(type, xi);
    return density * jacobian(type, x, xi) * N * N.transpose();
  });
}

TEST_P(Mass, IsTheFineQuadratureOnStraightAndCurvedCells) {
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const auto& x : {straight_cell(type, seed), curved_cell(type, seed)}) {
      const Eigen::MatrixXd expected = fine_mass(type, x);
      EXPECT_LT((mass_of(type, x) - expected).norm(), 1e-13 * expected.norm());
    }
}

TEST_P(Mass, IsExactlySymmetricAndPositiveDefinite) {
  for (const auto& x : {straight_cell(type, 8), curved_cell(type, 8)}) {
    const auto M = mass_of(type, x);
    EXPECT_EQ(M, Eigen::MatrixXd(M.transpose()));
    EXPECT_GT(test::symmetric_eigenvalues(M).minCoeff(), 0);
  }
}

TEST_P(Mass, SumsToVolumeTimesDensity) {
  const auto x = curved_cell(type, 9);
  EXPECT_NEAR(mass_of(type, x).sum(), density * volume(type, x), 1e-13 * volume(type, x));
}

TEST_P(Mass, IsUnchangedByRotationAndFarFromTheOrigin) {
  for (const auto& cell : {straight_cell(type, 10), curved_cell(type, 10)}) {
    const auto x = rounded(cell);
    const auto M = mass_of(type, x);
    EXPECT_EQ(M, mass_of(type, far_away(x)));
    EXPECT_LT((mass_of(type, mapped(rotation(), x)) - M).norm(), 1e-14 * M.norm());
  }
}

TEST(Tet10Mass, RowsOfAStraightCellSplitTheMass) {
  const auto x = straight_cell(CellType::tet10, 11);
  const double m = density * volume(CellType::tet10, x);
  const Eigen::VectorXd rows = mass_of(CellType::tet10, x).rowwise().sum();
  for (int a = 0; a < 10; ++a) EXPECT_NEAR(rows[a], a < 4 ? -m / 20 : m / 5, 1e-14 * m);
}

TEST(Tet10Mass, ClosedFormIsTheQuadrature) {
  const auto x = straight_cell(CellType::tet10, 12);
  ASSERT_TRUE(straight(CellType::tet10, x));
  const Eigen::MatrixXd expected = mass_by_quadrature(CellType::tet10, x, density);
  EXPECT_LT((mass_of(CellType::tet10, x) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Tet10Mass, TellsAlmostStraightFromStraight) {
  auto x = straight_cell(CellType::tet10, 13);
  EXPECT_TRUE(straight(CellType::tet10, x));
  x(1, 7) += 1e-13;
  EXPECT_FALSE(straight(CellType::tet10, x));
}

TEST(Tet4Mass, IsTwoOneOverTwenty) {
  const Eigen::MatrixXd M = mass(CellType::tet4, reference_cell(CellType::tet4), 120);
  EXPECT_EQ(M, Eigen::MatrixXd(Eigen::MatrixXd::Ones(4, 4) + Eigen::MatrixXd::Identity(4, 4)));
}

}  // namespace
}  // namespace ritz::fem::testing
