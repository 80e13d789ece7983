// Eigenvalues of small symmetric matrices against what defines them, and a closed form.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "ritz/algebra/dense.hpp"
#include "ritz/base/error.hpp"

namespace ritz::algebra {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The second difference on n points: 2 − 2 cos(kπ/(n+1)).
MatrixXd second_difference(Index n) {
  MatrixXd A = 2 * MatrixXd::Identity(n, n);
  A.diagonal(1).setConstant(-1);
  A.diagonal(-1).setConstant(-1);
  return A;
}

TEST(SymmetricEigen, OfTheSecondDifference) {
  for (const Index n : {1, 2, 7, 60}) {
    const MatrixXd A = second_difference(n);
    const auto [values, vectors] = symmetric_eigen(A);
    for (Index k = 0; k < n; ++k)
      EXPECT_NEAR(values[k], 2 - 2 * std::cos(double(k + 1) * std::numbers::pi / double(n + 1)), 1e-14 * double(n));
    EXPECT_LE((A * vectors - vectors * values.asDiagonal()).norm(), 1e-13 * double(n));
    EXPECT_LE((vectors.transpose() * vectors - MatrixXd::Identity(n, n)).norm(), 1e-13 * double(n));
    EXPECT_LE((symmetric_eigenvalues(A) - values).norm(), 1e-13 * double(n));
  }
}

TEST(SymmetricEigen, ReadsTheLowerTriangle) {
  MatrixXd A = second_difference(5);
  const auto values = symmetric_eigenvalues(A);
  A.triangularView<Eigen::StrictlyUpper>().setConstant(17);
  EXPECT_EQ(symmetric_eigenvalues(A), values);
}

TEST(SymmetricEigen, OfNothing) {
  const auto [values, vectors] = symmetric_eigen(MatrixXd(0, 0));
  EXPECT_EQ(values.size(), 0);
  EXPECT_EQ(vectors.size(), 0);
}

TEST(SymmetricEigen, RefusesWhatIsNotFinite) {
  MatrixXd A = second_difference(3);
  A(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(symmetric_eigen(A), NumericalError);
}

}  // namespace

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A matrix of the given rank.
MatrixXd sample(Index rows, Index columns, Index rank) {
  const MatrixXd left =
      MatrixXd::NullaryExpr(rows, rank, [](Index i, Index j) { return std::cos(double(3 * i + 7 * j)); });
  const MatrixXd right =
      MatrixXd::NullaryExpr(columns, rank, [](Index i, Index j) { return std::sin(double(5 * i * i + 2 * j)); });
  return left * right.transpose();
}

TEST(Svd, LeftVectorsDiagonaliseTheGramMatrix) {
  for (const auto& [rows, columns] : {std::pair<Index, Index>{7, 4}, {4, 7}, {5, 5}, {1, 6}, {6, 1}}) {
    const MatrixXd A = sample(rows, columns, std::min(rows, columns));
    const auto [sigma, U] = left_singular_vectors(A);
    EXPECT_LE((U.transpose() * U - MatrixXd::Identity(U.cols(), U.cols())).norm(), 1e-13);
    EXPECT_LE((A * A.transpose() * U - U * MatrixXd(sigma.array().square().matrix().asDiagonal())).norm(),
              1e-12 * A.squaredNorm());
    EXPECT_TRUE(std::is_sorted(sigma.data(), sigma.data() + sigma.size(), std::greater<>()));
  }
}

TEST(Svd, RightVectorsSpanTheNullSpaceToo) {
  for (const auto& [rows, columns] : {std::pair<Index, Index>{7, 5}, {3, 6}, {2, 2}}) {
    const Index rank = 2;
    const MatrixXd A = sample(rows, columns, rank);
    const auto [sigma, V] = right_singular_vectors(A);
    ASSERT_EQ(V.cols(), columns);
    EXPECT_LE((V.transpose() * V - MatrixXd::Identity(columns, columns)).norm(), 1e-13);
    EXPECT_LE((A * V.rightCols(columns - rank)).norm(), 1e-13 * A.norm());
    EXPECT_GT(sigma[rank - 1], 1e-6 * sigma[0]);
  }
}

TEST(Svd, NearestOrthogonalIsThePolarFactor) {
  const MatrixXd A = sample(5, 5, 2) + 0.5 * MatrixXd::Identity(5, 5), O = nearest_orthogonal(A), S = A * O.transpose();
  EXPECT_LE((O.transpose() * O - MatrixXd::Identity(5, 5)).norm(), 1e-13);
  EXPECT_LE((S - S.transpose()).norm(), 1e-13 * A.norm());
  EXPECT_GT(symmetric_eigenvalues(S)[0], 0);
}

TEST(Svd, OfNothing) {
  EXPECT_EQ(left_singular_vectors(MatrixXd(0, 3)).sigma.size(), 0);
  EXPECT_EQ(right_singular_vectors(MatrixXd(0, 3)).vectors, MatrixXd::Identity(3, 3));
}

}  // namespace

}  // namespace ritz::algebra
