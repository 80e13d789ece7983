// Products of distributed tall matrices against Eigen's on the whole.
#include <gtest/gtest.h>

#include "algebra/chain.hpp"
#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

namespace {

using namespace test;

constexpr PetscInt tall = 23;

// Products go through panels of eight columns, parts of one, and single columns.
TEST(Multivector, MultipliesAnyNumberOfColumns) {
  const Matrix A = tridiagonal(tall, 3, -0.5);
  for (int columns = 0; columns <= 19; ++columns) {
    const auto x = whole_random(tall, columns, 1);
    const Tall y = multiply(A, my_part(x));
    ASSERT_EQ(y.cols(), columns);
    EXPECT_LE(max_over_ranks(y - my_part(dense(tall, 3, -0.5) * x)), 1e-15) << columns;
  }
}

TEST(Multivector, CombinesColumns) {
  const auto x = whole_random(tall, 5, 7), c = whole_random(5, 3, 8), y = whole_random(tall, 3, 9);
  Tall rest = my_part(y);
  subtract(rest, my_part(x), c);
  EXPECT_LE(max_over_ranks(combine(my_part(x), c) - my_part(x * c)), 1e-14);
  EXPECT_LE(max_over_ranks(rest - my_part(y - x * c)), 1e-14);
  EXPECT_EQ(max_over_ranks(combine(my_part(x).leftCols(0), c.topRows(0))), 0);
  EXPECT_EQ(inner(world, my_part(x).leftCols(0), my_part(y)).rows(), 0);
}

TEST(Multivector, MultipliesIntoPartsOfAnother) {
  const Matrix A = tridiagonal(tall, 3, -0.5);
  const auto x = whole_random(tall, 2, 2);
  Tall y = Tall::Constant(my_rows(tall).count, 4, 7);
  multiply(A, my_part(x), y.middleCols(1, 2));
  EXPECT_LE(max_over_ranks(y.middleCols(1, 2) - my_part(dense(tall, 3, -0.5) * x)), 1e-15);
  EXPECT_LE(max_over_ranks((y.col(0).array() - 7).matrix()) + max_over_ranks((y.col(3).array() - 7).matrix()), 0);
}

TEST(Multivector, InnerProductsAreWholeOnEachRank) {
  const auto x = whole_random(tall, 3, 3), y = whole_random(tall, 5, 4);
  const Eigen::MatrixXd product = inner(world, my_part(x), my_part(y));
  EXPECT_LE((product - x.transpose() * y).cwiseAbs().maxCoeff(), 1e-14);
  Eigen::MatrixXd highest = product, lowest = product;
  MPI_Allreduce(MPI_IN_PLACE, highest.data(), static_cast<int>(highest.size()), MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, lowest.data(), static_cast<int>(lowest.size()), MPI_DOUBLE, MPI_MIN, world);
  EXPECT_EQ(highest, lowest);
}

TEST(Multivector, ColumnNorms) {
  const auto x = whole_random(tall, 6, 5);
  const Eigen::VectorXd expected = x.colwise().norm();
  EXPECT_LE((column_norms(world, my_part(x)) - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Multivector, DenseViewsShareTheirNumbers) {
  Tall x = my_part(whole_random(tall, 3, 6));
  const Matrix view = as_dense(world, x);
  PetscInt rows = 0, columns = 0;
  MatGetSize(view, &rows, &columns);
  EXPECT_EQ(rows, tall);
  EXPECT_EQ(columns, 3);
  x *= 2;
  PetscReal norm = 0;
  MatNorm(view, NORM_FROBENIUS, &norm);
  EXPECT_NEAR(norm, 2 * whole_random(tall, 3, 6).norm(), 1e-13);
}

}  // namespace

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

}  // namespace ritz::algebra
