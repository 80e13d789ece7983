// Contributions of several ranks to the same rows add up, whoever owns them.
#include "ritz/petsc/accumulate.hpp"

#include <gtest/gtest.h>

#include "petsc/chain.hpp"

namespace ritz::petsc {
namespace {

using namespace test;

TEST(Accumulate, AddsWhatAllRanksGive) {
  constexpr PetscInt n = 12;
  const Share rows = my_rows(n);
  const int me = parallel::rank(world), ranks = parallel::size(world);
  std::vector<std::int64_t> numbers;  // each rank gives to all rows, and twice to row 0
  for (PetscInt i = n - 1; i >= 0; --i) numbers.push_back(i);
  numbers.push_back(0);
  Tall values(n + 1, 2);
  for (PetscInt i = 0; i <= n; ++i)
    values.row(i) << 1, (me + 1) * static_cast<double>(numbers[static_cast<std::size_t>(i)] + 1);
  const Tall sums = accumulate(world, numbers, values, rows.count);
  ASSERT_EQ(sums.rows(), rows.count);
  const double ranks_sum = ranks * (ranks + 1) / 2.0;
  for (PetscInt i = 0; i < rows.count; ++i) {
    const int times = rows.first + i == 0 ? 2 : 1;
    EXPECT_EQ(sums(i, 0), times * ranks);
    EXPECT_EQ(sums(i, 1), times * ranks_sum * (rows.first + i + 1));
  }
}

TEST(Accumulate, TakesRanksThatGiveNothing) {
  const Share rows = my_rows(3);
  const std::vector<std::int64_t> numbers(parallel::rank(world) == 0 ? 1 : 0, 2);
  const Tall sums =
      accumulate(world, numbers, Tall::Constant(static_cast<Eigen::Index>(numbers.size()), 1, 5.0), rows.count);
  for (PetscInt i = 0; i < rows.count; ++i) EXPECT_EQ(sums(i, 0), rows.first + i == 2 ? 5 : 0);
}

}  // namespace
}  // namespace ritz::petsc
