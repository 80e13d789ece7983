// A failure on one rank is everybody's failure, with the same words, and nobody hangs.
#include "ritz/parallel/guard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {
namespace {

using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

const MPI_Comm world = MPI_COMM_WORLD;
const auto on = [](int who, auto work) {
  return [=] {
    together(world, [&] {
      if (rank(world) == who) work();
    });
  };
};

TEST(Guard, GoesOnWhereAllRanksDo) {
  int runs = 0;
  together(world, [&] { ++runs; });
  EXPECT_EQ(runs, 1);
}

TEST(Guard, CarriesAnInputErrorOfAnyRankToAll) {
  for (int who = 0; who < size(world); ++who)
    EXPECT_THAT(on(who, [] { throw InputError("line 3 is wrong"); }),
                ThrowsMessage<InputError>(StrEq("line 3 is wrong")));
}

TEST(Guard, CarriesTheReasonOfAnError) {
  for (int who = 0; who < size(world); ++who) try {
      on(who, [] { throw InputError("it moves", Reason::rigid_motions); })();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const InputError& error) {
      EXPECT_EQ(error.reason, Reason::rigid_motions);
    }
  try {
    on(size(world) - 1, [] { throw NumericalError("no convergence", Reason::iterative_solver_failed); })();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.reason, Reason::iterative_solver_failed);
  }
}

TEST(Guard, CarriesANumericalError) {
  EXPECT_THAT(on(size(world) - 1, [] { throw NumericalError("no convergence"); }),
              ThrowsMessage<NumericalError>(StrEq("no convergence")));
}

TEST(Guard, TakesOtherErrorsForNumericalOnes) {
  EXPECT_THAT(on(size(world) - 1, [] { throw std::out_of_range("index"); }),
              ThrowsMessage<NumericalError>(StrEq("index")));
  EXPECT_THAT(on(0, [] { throw std::bad_alloc(); }), ThrowsMessage<NumericalError>(HasSubstr("memory ran out")));
}

TEST(Guard, LetsTheLowestRankSpeak) {
  const auto all_fail = [] {
    together(world, [] {
      if (rank(world) == 0) throw InputError("rank 0");
      throw NumericalError("another rank");
    });
  };
  EXPECT_THAT(all_fail, ThrowsMessage<InputError>(StrEq("rank 0")));
}

TEST(Guard, CarriesWordsOfAnyLength) {
  const std::string longer(100'000, 'x');
  EXPECT_THAT(on(size(world) - 1, [&] { throw InputError(longer); }), ThrowsMessage<InputError>(StrEq(longer)));
  EXPECT_THAT(on(0, [] { throw InputError(""); }), ThrowsMessage<InputError>(StrEq("")));
}

TEST(Guard, RunsRootWorkOnRank0Alone) {
  int runs = 0;
  on_root(world, [&] { ++runs; });
  EXPECT_EQ(runs, rank(world) == 0);
  EXPECT_THAT([] { on_root(world, [] { throw InputError("no such file"); }); },
              ThrowsMessage<InputError>(StrEq("no such file")));
}

TEST(Guard, LeavesTheCommunicatorUsable) {
  EXPECT_THROW(on(0, [] { throw InputError("once"); })(), InputError);
  EXPECT_EQ(sum(world, std::int64_t{1}), size(world));
}

}  // namespace
}  // namespace ritz::parallel
