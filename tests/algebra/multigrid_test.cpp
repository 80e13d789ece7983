// What makes a cycle a preconditioner: linear, symmetric, definite, and close to the inverse.
#include "ritz/algebra/multigrid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "algebra/chain.hpp"

namespace ritz::algebra {
namespace {

using namespace test;

constexpr PetscInt unknowns = 300;

class MultigridOfAChain : public testing::Test {
 protected:
  Matrix K = tridiagonal(unknowns, 2.001, -1);
  Multigrid cycle{K, Tall::Ones(my_rows(unknowns).count, 1), "test_"};
  Tall x = my_part(whole_random(unknowns, 8, 1));

  Tall cycled(const Tall& r) const {
    Tall z(r.rows(), r.cols());
    cycle.apply(r, z);
    return z;
  }
};

TEST_F(MultigridOfAChain, HasLevels) { EXPECT_GE(cycle.levels(), 2); }

TEST_F(MultigridOfAChain, IsLinear) {
  Tall turned = x.rowwise().reverse();
  EXPECT_LE(max_over_ranks(cycled(2 * x + turned) - 2 * cycled(x) - cycled(turned)), 1e-9);
}

TEST_F(MultigridOfAChain, IsSymmetricAndDefinite) {
  const Eigen::MatrixXd energy = inner(world, x, cycled(x));
  EXPECT_LE((energy - energy.transpose()).norm(), 1e-8 * energy.norm());
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(energy).info(), Eigen::Success);
}

TEST_F(MultigridOfAChain, TakesMostOfAnErrorAway) {
  const auto energy = [&](const Tall& e) { return inner(world, e, multiply(K, e)).diagonal().sum(); };
  Tall error = x;
  for (int step = 0; step < 10; ++step) error -= cycled(multiply(K, error));
  EXPECT_LE(energy(error), 1e-4 * energy(x));
}

}  // namespace
}  // namespace ritz::algebra
