// Rows scattered over ranks come back in the file's order, whole.
#include "ritz/parallel/redistribute.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ritz/base/random.hpp"

namespace ritz::parallel {
namespace {

const MPI_Comm all_ranks = MPI_COMM_WORLD;

/// The rows of 0 ... total-1 that a hash gives to this rank, in an order of its own.
std::vector<std::int64_t> my_rows(std::int64_t total) {
  std::vector<std::int64_t> rows;
  for (std::int64_t i = total - 1; i >= 0; --i)
    if (split_mix(static_cast<std::uint64_t>(i)) % static_cast<std::uint64_t>(size(all_ranks)) ==
        static_cast<std::uint64_t>(rank(all_ranks)))
      rows.push_back(i);
  return rows;
}

TEST(Redistribute, SlicesFollowOneAnotherAndAreEven) {
  for (const std::int64_t total : {0, 1, 2, 3, 7, 100, 101}) {
    const Slice slice = even_slice(all_ranks, total);
    EXPECT_EQ(slice.total, total);
    EXPECT_EQ(slice.first, sum_before(all_ranks, slice.count));
    EXPECT_EQ(sum(all_ranks, slice.count), total);
    EXPECT_LE(max(all_ranks, slice.count) - min(all_ranks, slice.count), 1);
  }
}

TEST(Redistribute, RowsComeBackFromSlices) {
  for (const std::int64_t total : {1, 2, 7, 100}) {
    const auto mine = my_rows(total);
    RowMatrix values(static_cast<Eigen::Index>(mine.size()), 2);
    for (std::size_t i = 0; i < mine.size(); ++i)
      values.row(static_cast<Eigen::Index>(i)) << static_cast<double>(mine[i]), .5 - static_cast<double>(mine[i]);
    const RowMatrix back = from_slices(all_ranks, mine, to_slices(all_ranks, mine, values, total), total);
    EXPECT_EQ(back, values);
  }
}

TEST(Redistribute, OwnersHoldTheirRows) {
  for (const int ranks : {1, 2, 3, 7, 64})
    for (const std::int64_t total : {1, 2, 5, 64, 1000}) {
      std::int64_t last = 0;
      for (std::int64_t row = 0; row < total; ++row) {
        const int owner = slice_owner(ranks, total, row);
        EXPECT_LE(total * owner / ranks, row);
        EXPECT_LT(row, total * (owner + 1) / ranks);
        EXPECT_GE(owner, last);
        last = owner;
      }
    }
  const Slice slice = even_slice(all_ranks, 17);
  for (std::int64_t row = slice.first; row < slice.first + slice.count; ++row)
    EXPECT_EQ(slice_owner(size(all_ranks), 17, row), rank(all_ranks));
}

TEST(Redistribute, RowsArriveInOrder) {
  for (const std::int64_t total : {1, 2, 50}) {
    const auto rows = my_rows(total);
    RowMatrix values(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
      values.row(static_cast<Eigen::Index>(i))
          .setLinSpaced(static_cast<double>(rows[i]), static_cast<double>(rows[i]) + 1);
    const RowMatrix slice = to_slices(all_ranks, rows, values, total);
    const Slice mine = even_slice(all_ranks, total);
    ASSERT_EQ(slice.rows(), mine.count);
    ASSERT_EQ(slice.cols(), 3);
    for (Eigen::Index i = 0; i < slice.rows(); ++i) {
      EXPECT_EQ(slice(i, 0), static_cast<double>(mine.first + i));
      EXPECT_EQ(slice(i, 2), static_cast<double>(mine.first + i) + 1);
    }
  }
}

TEST(Redistribute, MissingKeysLeaveNoHoles) {
  constexpr std::int64_t keys = 90;
  auto present = my_rows(keys);
  std::erase_if(present, [](std::int64_t key) { return key % 3 == 1; });
  std::vector<std::int64_t> values;
  for (const auto key : present) values.insert(values.end(), {10 * key, 10 * key + 1});
  const auto sorted = sorted_by_key(all_ranks, present, values, 2, keys);
  const Slice mine = even_slice(all_ranks, keys);
  std::vector<std::int64_t> expected;
  for (auto key = mine.first; key < mine.first + mine.count; ++key)
    if (key % 3 != 1) expected.insert(expected.end(), {10 * key, 10 * key + 1});
  EXPECT_EQ(sorted, expected);
}

}  // namespace
}  // namespace ritz::parallel
