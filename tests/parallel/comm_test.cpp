// The collective verbs against what each rank can work out alone.
#include "ritz/parallel/comm.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ritz::parallel {
namespace {

const MPI_Comm everyone = MPI_COMM_WORLD;

TEST(Comm, ReducesOverRanks) {
  const std::int64_t me = rank(everyone), n = size(everyone);
  EXPECT_EQ(sum(everyone, me), n * (n - 1) / 2);
  EXPECT_EQ(min(everyone, me + 5), 5);
  EXPECT_EQ(max(everyone, me), n - 1);
  EXPECT_EQ(sum(everyone, 0.5), 0.5 * static_cast<double>(n));
  EXPECT_EQ(sum_before(everyone, me + 1), me * (me + 1) / 2);
}

TEST(Vote, HearsEveryRank) {
  EXPECT_EQ(vote(everyone, true), Vote::all_yes);
  EXPECT_EQ(vote(everyone, rank(everyone) != size(everyone) - 1), Vote::some_no);
  EXPECT_EQ(vote(everyone, false), Vote::some_no);
}

TEST(Vote, ARankThatFailsWhereTheOthersAreElsewhereLearnsThatItIsAlone) {
  if (size(everyone) == 1) GTEST_SKIP() << "one rank is never alone";
  int told = 0;
  if (rank(everyone) == 0) {
    EXPECT_EQ(vote(everyone, false), Vote::alone);
    for (int other = 1; other < size(everyone); ++other) MPI_Send(&told, 1, MPI_INT, other, 0, everyone);
  } else {
    MPI_Recv(&told, 1, MPI_INT, 0, 0, everyone, MPI_STATUS_IGNORE);
    EXPECT_EQ(vote(everyone, true), Vote::some_no);
  }
  MPI_Barrier(everyone);
}

TEST(Comm, AddsMatricesAlsoWhenTheyArePartsOfOthers) {
  Eigen::MatrixXd whole = Eigen::MatrixXd::Constant(4, 3, -1);
  auto part = whole.block(1, 0, 2, 3);
  part << 1, 2, 3, 4, 5, 6;
  const Eigen::MatrixXd expected = part * size(everyone);
  sum_in_place(everyone, part);
  EXPECT_EQ(Eigen::MatrixXd(part), expected);
  EXPECT_TRUE((whole.row(0).array() == -1).all() && (whole.row(3).array() == -1).all());
  Eigen::MatrixXd none(0, 3);
  sum_in_place(everyone, none);
}

TEST(Comm, BroadcastsFromAnyRank) {
  const int last = size(everyone) - 1;
  std::vector<double> numbers;
  std::string text = "old and long";
  std::vector<std::string> texts = {"a", "b", "c", "d"};
  if (rank(everyone) == last) {
    numbers = {1.5, -2};
    text = "new";
    texts = {"", "two\nlines"};
  }
  broadcast(everyone, numbers, last);
  broadcast(everyone, text, last);
  broadcast(everyone, texts, last);
  EXPECT_EQ(numbers, (std::vector{1.5, -2.0}));
  EXPECT_EQ(text, "new");
  EXPECT_EQ(texts, (std::vector<std::string>{"", "two\nlines"}));
}

TEST(Comm, GathersListsOfUnequalLengthInTheOrderOfRanks) {
  const int me = rank(everyone);
  std::vector<std::int32_t> expected;
  for (int p = 0; p < size(everyone); ++p) expected.insert(expected.end(), static_cast<std::size_t>(p), p);
  EXPECT_EQ(gather_all(everyone, std::vector<std::int32_t>(static_cast<std::size_t>(me), me)), expected);
}

/// Rank p sends p + 2 q numbers to rank q, none where that is 0.
TEST(Comm, ExchangesListsBetweenAllPairs) {
  const int me = rank(everyone), n = size(everyone);
  const auto list = [&](int from, int to) {
    std::vector<std::int64_t> values(static_cast<std::size_t>(from + 2 * to));
    std::iota(values.begin(), values.end(), 1000 * from + 100 * to);
    return values;
  };
  std::vector<std::vector<std::int64_t>> outgoing;
  for (int q = 0; q < n; ++q) outgoing.push_back(list(me, q));
  const auto incoming = parallel::exchange(everyone, outgoing);
  ASSERT_EQ(incoming.size(), static_cast<std::size_t>(n));
  for (int p = 0; p < n; ++p) EXPECT_EQ(incoming[static_cast<std::size_t>(p)], list(p, me));
}

}  // namespace
}  // namespace ritz::parallel
