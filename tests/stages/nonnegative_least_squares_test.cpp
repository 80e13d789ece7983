// Non-negative least squares: against all subsets of columns, by the conditions of optimality, and on any number of
// ranks.
#include "ritz/stages/nonnegative_least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ritz/base/random.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index all_columns = std::numeric_limits<Index>::max();

MatrixXd random(std::uint64_t stream, Index rows, Index columns) {
  return MatrixXd::NullaryExpr(
      rows, columns, [&](Index i, Index j) { return uniform(stream, static_cast<std::uint64_t>(i + rows * j)); });
}

/// The columns dealt out to the ranks, the last one first. `comm` may be this rank alone.
DistributedColumns dealt(MPI_Comm comm, const MatrixXd& A) {
  DistributedColumns columns;
  for (Index j = A.cols() - 1; j >= 0; --j)
    if (j % parallel::size(comm) == parallel::rank(comm)) columns.numbers.push_back(j);
  const auto mine = columns.numbers;
  columns.products = [mine, A](const VectorXd& y) {
    VectorXd products(static_cast<Index>(mine.size()));
    for (Index i = 0; i < products.size(); ++i) products[i] = A.col(mine[static_cast<std::size_t>(i)]).dot(y);
    return products;
  };
  columns.columns = [mine, A](const std::vector<Index>& places) {
    MatrixXd values(A.rows(), static_cast<Index>(places.size()));
    for (Index i = 0; i < values.cols(); ++i)
      values.col(i) = A.col(mine[static_cast<std::size_t>(places[static_cast<std::size_t>(i)])]);
    return values;
  };
  return columns;
}

NonnegativeFit converged(const MatrixXd& A, const VectorXd& b, MPI_Comm comm = MPI_COMM_WORLD) {
  return nonnegative_least_squares(comm, dealt(comm, A), b, {1e-14, all_columns, all_columns},
                                   [](const auto&) { return Index{0}; });
}

VectorXd spread(const NonnegativeFit& fit, Index columns) {
  VectorXd w = VectorXd::Zero(columns);
  for (std::size_t i = 0; i < fit.numbers.size(); ++i) w[fit.numbers[i]] = fit.weights[static_cast<Index>(i)];
  return w;
}

/// ½ ‖A w − b‖² of the best w ≥ 0, from the least squares solutions of all subsets of columns.
double least_of_subsets(const MatrixXd& A, const VectorXd& b) {
  double least = b.squaredNorm() / 2;
  for (int subset = 1; subset < 1 << A.cols(); ++subset) {
    std::vector<Index> chosen;
    for (int j = 0; j < A.cols(); ++j)
      if (subset >> j & 1) chosen.push_back(j);
    const MatrixXd C = A(Eigen::all, chosen);
    const Eigen::ColPivHouseholderQR<MatrixXd> factors(C);
    if (factors.rank() < C.cols()) continue;  // a smaller subset has the same span
    const VectorXd w = factors.solve(b);
    if (w.minCoeff() >= 0) least = std::min(least, (b - C * w).squaredNorm() / 2);
  }
  return least;
}

void expect_least(const MatrixXd& A, const VectorXd& b) {
  const auto fit = converged(A, b);
  const VectorXd w = spread(fit, A.cols());
  EXPECT_TRUE(fit.optimal);
  EXPECT_LE((fit.residual - (b - A * w)).norm(), 1e-13 * b.norm() + 1e-13 * (A * w).norm());
  EXPECT_NEAR((b - A * w).squaredNorm() / 2, least_of_subsets(A, b), 1e-10 * b.squaredNorm());
}

TEST(NonnegativeLeastSquares, IsTheBestOfAllSubsets) {
  for (std::uint64_t stream = 0; stream < 12; ++stream) {
    const MatrixXd A = random(stream, 6 + static_cast<Index>(stream), 9);
    expect_least(A, random(100 + stream, A.rows(), 1));
  }
}

TEST(NonnegativeLeastSquares, IsTheBestOfAllSubsetsOfDependentColumns) {
  for (std::uint64_t stream = 0; stream < 12; ++stream) {
    const MatrixXd A = random(stream, 12, 4) * random(50 + stream, 4, 9);
    expect_least(A, random(100 + stream, 12, 1));
    MatrixXd pairs(12, 8);
    pairs << A.leftCols(4), A.leftCols(4) + 1e-5 * random(200 + stream, 12, 4);
    expect_least(pairs, random(100 + stream, 12, 1));
  }
}

/// Weak duality: for any y with Aᵀy ≤ 0, ½ ‖A w − b‖² ≥ yᵀb − ½ ‖y‖² for all w ≥ 0. At the best w, y = b − A w makes
/// them equal.
TEST(NonnegativeLeastSquares, MeetsTheConditionsOfOptimality) {
  const MatrixXd A = random(7, 60, 400).array() + .3;
  MatrixXd scaled = A;
  for (Index j = 0; j < A.cols(); ++j) scaled.col(j) *= std::pow(10.0, static_cast<double>(j % 9) - 4);
  const VectorXd b = random(8, 60, 1);
  for (const MatrixXd& M : {A, scaled}) {
    const auto fit = converged(M, b);
    EXPECT_TRUE(fit.optimal);
    EXPECT_GT(fit.weights.minCoeff(), 0);
    const VectorXd gradients = M.transpose() * fit.residual;
    EXPECT_LE((gradients.array() / M.colwise().norm().transpose().array()).maxCoeff(), 1e-9 * b.norm());
    EXPECT_NEAR(fit.residual.dot(b), fit.residual.squaredNorm(), 1e-10 * b.squaredNorm());
  }
}

TEST(NonnegativeLeastSquares, FindsASparseCombination) {
  const MatrixXd A = random(3, 200, 1000).array() + .5;
  VectorXd w = VectorXd::Zero(1000);
  for (Index k = 0; k < 30; ++k) w[33 * k + 5] = 1 + uniform(4, static_cast<std::uint64_t>(k)) / 2;
  const auto fit = converged(A, A * w);
  EXPECT_LE((spread(fit, 1000) - w).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(NonnegativeLeastSquares, TakesTheLowestNumberOfEqualColumnsAndNoneOfZeros) {
  MatrixXd A = random(5, 30, 80);
  A.col(10).setZero();
  for (Index j = 40; j < 80; ++j) A.col(j) = A.col(79 - j);
  const auto fit = converged(A, random(6, 30, 1));
  EXPECT_FALSE(fit.numbers.empty());
  for (const auto number : fit.numbers) {
    EXPECT_LT(number, 40);
    EXPECT_NE(number, 10);
  }
}

TEST(NonnegativeLeastSquares, HasNoColumnWhereNoneHelps) {
  const MatrixXd A = random(5, 30, 20);
  for (const auto& fit :
       {converged(A, VectorXd::Zero(30)), converged(MatrixXd::Zero(30, 20), VectorXd::Ones(30)),
        converged(MatrixXd(30, 0), VectorXd::Ones(30)), converged(-MatrixXd::Identity(30, 30), VectorXd::Ones(30))}) {
    EXPECT_TRUE(fit.optimal);
    EXPECT_TRUE(fit.numbers.empty());
    EXPECT_EQ(fit.weights.size(), 0);
  }
}

TEST(NonnegativeLeastSquares, IsShownAtTheNumbersThatAreAskedForAndHasTheMost) {
  const MatrixXd A = random(9, 300, 900).array() + .2;
  const VectorXd b = A.rowwise().sum();
  std::vector<Index> seen;
  double last = b.norm();
  const auto show = [&](const NonnegativeFit& at) {
    seen.push_back(at.weights.size());
    EXPECT_GT(at.weights.minCoeff(), 0);
    EXPECT_LT(at.residual.norm(), last);
    last = at.residual.norm();
    return seen.size() == 1 ? Index{50} : all_columns;
  };
  const auto fit = nonnegative_least_squares(MPI_COMM_WORLD, dealt(MPI_COMM_WORLD, A), b, {1e-12, 93, 7}, show);
  EXPECT_EQ(seen, (std::vector<Index>{7, 50, 93}));
  EXPECT_EQ(fit.weights.size(), 93);
  EXPECT_FALSE(fit.optimal);
  EXPECT_LE((fit.residual - (b - A * spread(fit, 900))).norm(), 1e-12 * b.norm());
  const auto ended = nonnegative_least_squares(MPI_COMM_WORLD, dealt(MPI_COMM_WORLD, A), b, {1e-12, 93, 7},
                                               [](const auto&) { return Index{0}; });
  EXPECT_EQ(ended.weights.size(), 7);
}

TEST(NonnegativeLeastSquares, IsTheSameOnAnyNumberOfRanks) {
  const MatrixXd A = random(11, 150, 600).array() + .1;
  const VectorXd b = A.rowwise().sum();
  const auto together = converged(A, b), alone = converged(A, b, MPI_COMM_SELF);
  ASSERT_EQ(together.numbers, alone.numbers);
  EXPECT_LE((together.weights - alone.weights).lpNorm<Eigen::Infinity>(), 1e-12 * alone.weights.maxCoeff());
}

TEST(NonnegativeLeastSquares, RanksTheColumnsInSinglePrecisionAlone) {
  const MatrixXd A = random(13, 150, 600).array() + .1;
  const VectorXd b = random(14, 150, 1);
  auto columns = dealt(MPI_COMM_WORLD, A);
  const auto exact = columns.products;
  columns.products = [&](const VectorXd& y) { return VectorXd(exact(y).cast<float>().cast<double>()); };
  const auto rounded = nonnegative_least_squares(MPI_COMM_WORLD, columns, b, {1e-14, all_columns, all_columns},
                                                 [](const auto&) { return Index{0}; });
  EXPECT_NEAR(rounded.residual.norm(), converged(A, b).residual.norm(), 1e-12 * b.norm());
}

}  // namespace
}  // namespace ritz::stages
