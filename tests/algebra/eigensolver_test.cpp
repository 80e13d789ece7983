// SLEPc's Krylov-Schur against the chain's closed spectrum.
#include "ritz/algebra/eigensolver.hpp"

#include <gtest/gtest.h>

#include "algebra/chain.hpp"

namespace ritz::algebra {
namespace {

using namespace test;

constexpr PetscInt masses = 60;
constexpr int wanted = 6;

class Eigensolver : public testing::Test {
 protected:
  Matrix K = tridiagonal(masses, 2, -1), M = tridiagonal(masses, 1, 0);
  const Tall none = Tall(my_rows(masses).count, 0);

  void check_pairs(const EigenPairs& pairs, int from, double tolerance) const {
    ASSERT_EQ(pairs.values.size(), wanted);
    for (int j = 0; j < wanted; ++j)
      EXPECT_NEAR(pairs.values[j] / chain_eigenvalue(masses, from + j), 1, tolerance) << j;
    const Tall residual = multiply(K, pairs.vectors) - pairs.vectors * pairs.values.asDiagonal();
    EXPECT_LE(column_norms(world, residual).maxCoeff(), 10 * tolerance);
  }
};

TEST_F(Eigensolver, KrylovSchurFindsTheSmallest) { check_pairs(krylov_schur(K, M, 0, none, wanted, 1e-12), 1, 1e-10); }

TEST_F(Eigensolver, KrylovSchurKeepsOutWhatIsDeflated) {
  const auto first = krylov_schur(K, M, 0, none, wanted, 1e-12);
  check_pairs(krylov_schur(K, M, -0.01, first.vectors, wanted, 1e-12), 1 + wanted, 1e-9);
}

}  // namespace
}  // namespace ritz::algebra
