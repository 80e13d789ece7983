// UᵀMU = I, the span kept and the rank revealed: from good sets, deficient ones, and of any scale.
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "algebra/chain.hpp"

namespace ritz::algebra {
namespace {

using namespace test;

constexpr PetscInt height = 40;

class Orthonormalise : public testing::Test {
 protected:
  Matrix M = tridiagonal(height, 4, 1);
  const Tall none = Tall(my_rows(height).count, 0);

  double error(const Tall& u) const {
    return (inner(world, u, multiply(M, u)) - Eigen::MatrixXd::Identity(u.cols(), u.cols())).cwiseAbs().maxCoeff();
  }

  /// How far the columns of x stick out of the span of u, relative to each column.
  double outside(const Tall& u, const Tall& x) const {
    const Eigen::MatrixXd coefficients = inner(world, u, multiply(M, x));
    const Eigen::VectorXd rest = column_norms(world, x - u * coefficients);
    return rest.cwiseQuotient(column_norms(world, x)).maxCoeff();
  }
};

TEST_F(Orthonormalise, KeepsTheSpanOfAFullSet) {
  const Tall x = my_part(whole_random(height, 7, 1));
  Tall u = x;
  ASSERT_EQ(orthonormalise(M, none, u), 7);
  EXPECT_LE(error(u), 1e-14);
  EXPECT_LE(outside(u, x), 1e-13);
}

TEST_F(Orthonormalise, RevealsTheRank) {
  const Eigen::MatrixXd basis = whole_random(height, 4, 2);
  const Tall x = my_part(basis * whole_random(4, 9, 3));
  Tall u = x;
  ASSERT_EQ(orthonormalise(M, none, u), 4);
  EXPECT_LE(error(u.leftCols(4)), 1e-13);
  EXPECT_LE(outside(u.leftCols(4), my_part(basis)), 1e-10);
}

TEST_F(Orthonormalise, DropsColumnsOfZeros) {
  Tall u = my_part(whole_random(height, 5, 4));
  u.col(1).setZero();
  u.col(4).setZero();
  ASSERT_EQ(orthonormalise(M, none, u), 3);
  EXPECT_LE(error(u.leftCols(3)), 1e-14);
  Tall zeros = Tall::Zero(u.rows(), 3);
  EXPECT_EQ(orthonormalise(M, none, zeros), 0);
  Tall empty = none;
  EXPECT_EQ(orthonormalise(M, none, empty), 0);
}

TEST_F(Orthonormalise, DoesNotMindTinyAndHugeColumns) {
  for (const double scale : {1e-140, 1e-20, 1.0, 1e20, 1e140}) {
    const Tall x = my_part(scale * whole_random(height, 5, 5));
    Tall u = x;
    ASSERT_EQ(orthonormalise(M, none, u), 5) << scale;
    EXPECT_LE(error(u), 1e-13) << scale;
  }
}

TEST_F(Orthonormalise, DoesNotMindColumnsOfUnlikeScale) {
  Eigen::MatrixXd x = whole_random(height, 5, 6);
  for (int j = 0; j < 5; ++j) x.col(j) *= std::pow(10.0, 30 * (j - 2));
  Tall u = my_part(x);
  ASSERT_EQ(orthonormalise(M, none, u), 5);
  EXPECT_LE(error(u), 1e-13);
  EXPECT_LE(outside(u, my_part(x)), 1e-12);
}

TEST_F(Orthonormalise, SeparatesNearlyParallelColumns) {
  for (const double apart : {1e-3, 1e-5}) {
    Eigen::MatrixXd x = whole_random(height, 3, 7);
    x.col(1) = x.col(0) + apart * x.col(1);
    Tall u = my_part(x);
    ASSERT_EQ(orthonormalise(M, none, u), 3) << apart;
    EXPECT_LE(error(u), 1e-13) << apart;
  }
}

TEST_F(Orthonormalise, StandsAcrossAnEarlierSet) {
  Tall before = my_part(whole_random(height, 6, 8));
  ASSERT_EQ(orthonormalise(M, none, before), 6);
  const Tall x = my_part(whole_random(height, 4, 9));
  Tall u = x;
  ASSERT_EQ(orthonormalise(M, before, u), 4);
  Tall both(x.rows(), 10);
  both << before, u;
  EXPECT_LE(error(both), 1e-13);
  EXPECT_LE(outside(both, x), 1e-12);
}

TEST_F(Orthonormalise, FindsNothingNewInsideAnEarlierSet) {
  Tall before = my_part(whole_random(height, 6, 10));
  ASSERT_EQ(orthonormalise(M, none, before), 6);
  Tall inside = before * whole_random(6, 3, 11);
  EXPECT_EQ(orthonormalise(M, before, inside), 0);
  Tall mixed(before.rows(), 4);
  mixed << before * whole_random(6, 3, 12), my_part(whole_random(height, 1, 13));
  ASSERT_EQ(orthonormalise(M, before, mixed), 1);
  EXPECT_LE(error(mixed.leftCols(1)), 1e-13);
  EXPECT_LE(inner(world, before, multiply(M, mixed.leftCols(1))).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace ritz::algebra
