// Solutions against what they came from; counts of negative pivots against the chain's closed spectrum.
#include "ritz/algebra/factorization.hpp"

#include <gtest/gtest.h>

#include "algebra/chain.hpp"
#include "ritz/base/error.hpp"

namespace ritz::algebra {
namespace {

using namespace test;

constexpr PetscInt n = 60;

class FactorizationOfAChain : public testing::Test {
 protected:
  Matrix K = tridiagonal(n, 2, -1), M = tridiagonal(n, 1, 0);
  Factorization solver{world, "test_"};
};

TEST_F(FactorizationOfAChain, SolvesBlocksOfAnyWidth) {
  solver.factor(K, M, 0);
  for (const int columns : {1, 3, 64, 70}) {
    const Tall x = my_part(whole_random(n, columns, 1));
    Tall solved(x.rows(), columns);
    solver.solve(multiply(K, x), solved);
    EXPECT_LE(max_over_ranks(solved - x), 1e-11);
  }
}

TEST_F(FactorizationOfAChain, SolvesInPlace) {
  solver.factor(K, M, 0.5);
  const Tall x = my_part(whole_random(n, 5, 2));
  Tall b = multiply(K, x) - 0.5 * multiply(M, x);
  solver.solve(b, b);
  EXPECT_LE(max_over_ranks(b - x), 1e-10);
}

TEST_F(FactorizationOfAChain, CountsTheEigenvaluesBelowAnyShift) {
  for (const int below : {0, 1, 2, 7, n / 2, n - 1, n}) {
    const double left = below == 0 ? -1 : chain_eigenvalue(n, below);
    const double right = below == n ? 5 : chain_eigenvalue(n, below + 1);
    solver.factor(K, M, (left + right) / 2);
    EXPECT_EQ(solver.negative_pivots(), below);
  }
}

TEST_F(FactorizationOfAChain, CountsCloseToAnEigenvalueOnEitherSide) {
  const double lambda = chain_eigenvalue(n, 10);
  solver.factor(K, M, lambda * (1 - 1e-9));
  EXPECT_EQ(solver.negative_pivots(), 9);
  solver.factor(K, M, lambda * (1 + 1e-9));
  EXPECT_EQ(solver.negative_pivots(), 10);
}

TEST_F(FactorizationOfAChain, CountsInsideAGeneralPencil) {
  const Matrix mass = tridiagonal(n, 4, 1);  // (K, M) share their vectors: λ = (2 - 2c) / (4 + 2c)
  const auto lambda = [](int j) {
    const double c = std::cos(j * std::numbers::pi / static_cast<double>(n + 1));
    return (2 - 2 * c) / (4 + 2 * c);
  };
  solver.factor(K, mass, (lambda(20) + lambda(21)) / 2);
  EXPECT_EQ(solver.negative_pivots(), 20);
}

TEST_F(FactorizationOfAChain, ForgetsEarlierShifts) {
  for (const double sigma : {3.0, 0.0, 1.0, 0.0}) {
    solver.factor(K, M, sigma);
    const Tall x = my_part(whole_random(n, 2, 3));
    Tall solved(x.rows(), 2);
    solver.solve(multiply(K, x) - sigma * x, solved);
    EXPECT_LE(max_over_ranks(solved - x), 1e-9) << sigma;
  }
}

TEST_F(FactorizationOfAChain, EstimatesBeforeItFactors) {
  const Matrix longer = tridiagonal(50'000, 2, -1);  // memory comes in megabytes
  const auto estimate = solver.analyse(longer);
  EXPECT_GT(estimate.flops, 0);
  EXPECT_GT(estimate.memory_rank, 0);
  EXPECT_GE(estimate.memory_total, estimate.memory_rank);
}

TEST(Factorization, SaysThatASingularMatrixIsSingular) {
  const Matrix zero = tridiagonal(n, 0, 0);
  Factorization solver(world, "test_");
  EXPECT_THROW(solver.factor(zero, zero, 0), NumericalError);
}

}  // namespace
}  // namespace ritz::algebra
