// What a program adds to what a method says of its failure.
#include "ritz/config/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "configured.hpp"

namespace ritz::config {
namespace {

using ::testing::StrEq;
using ::testing::ThrowsMessage;

using testing::with_box;

TEST(Advice, LeavesAMessageThatSaysAllAsItIs) {
  const Config config = with_box({});
  EXPECT_EQ(advised(InputError("the file is empty"), config), "the file is empty");
}

TEST(Advice, NamesTheOptionAndItsValueBeforeAndWhatHelpsBehind) {
  const Config config = with_box({"-basis", "30", "-derivatives", "4"});
  EXPECT_EQ(advised(InputError("there are 12", Reason::too_few_directions), config),
            "option -basis 30: there are 12; lower -basis, or raise -modes or -derivatives");
  EXPECT_EQ(advised(InputError("there are 3", Reason::too_few_modes_for_derivatives), config),
            "option -derivatives 4: there are 3; lower -derivatives");
  const Config accurate = with_box({"-accuracy", "1e-2", "-accuracy_scene", "s.toml"});
  EXPECT_EQ(advised(NumericalError("none is", Reason::accuracy_out_of_reach), accurate),
            "option -accuracy 0.01: none is; raise -modes or the target");
}

TEST(Advice, KeepsTheKindOfAnError) {
  const Config config = with_box({});
  const auto run = [&](const Work& work) { with_advice(work)(MPI_COMM_WORLD, config); };
  EXPECT_THAT([&] { run([](auto&&...) { throw InputError("it moves", Reason::rigid_motions); }); },
              ThrowsMessage<InputError>(StrEq("[static]: it moves; hold it with -fix, or let it move with [time]")));
  EXPECT_THAT([&] { run([](auto&&...) { throw NumericalError("no", Reason::iterative_solver_failed); }); },
              ThrowsMessage<NumericalError>(StrEq("no; use -solver direct, or a mesh of better shape")));
  EXPECT_NO_THROW(run([](auto&&...) {}));
}

}  // namespace
}  // namespace ritz::config
