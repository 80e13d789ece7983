// Eigenvalues of small symmetric matrices against what defines them, and a closed form.
#include "ritz/petsc/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ritz/base/error.hpp"

namespace ritz::petsc {
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
}  // namespace ritz::petsc
