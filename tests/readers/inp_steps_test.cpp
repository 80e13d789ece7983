// Supports by step: what the first frequency step has in effect counts, as in CalculiX and Abaqus.
#include <gtest/gtest.h>

#include <set>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

/// The two tetrahedra without supports, and then these.
std::string deck(const std::string& steps) {
  const auto text = inp_text();
  return text.substr(0, text.find("*STEP")) + steps;
}

/// "vertex component" of all that is held.
std::set<std::string> held(const FileMesh& mesh) {
  std::set<std::string> result;
  for (const auto& support : mesh.supports)
    for (const Index v : support.vertices)
      for (std::size_t i = 0; i < 3; ++i)
        if (support.held[i]) result.insert(std::to_string(v) + "xyz"[i]);
  return result;
}

const std::string frequency = "*STEP\n*FREQUENCY\n3\n";
const std::string end = "*END STEP\n";

struct Steps {
  const char* what;
  std::string deck;
  std::set<std::string> held;
  std::size_t notes;
};

// Vertices 10, 7, 30, 4000, 50 are the positions 0 to 4.
const Steps cases[] = {
    {"model data hold in a step", "*BOUNDARY\n10, 1\n" + frequency + end, {"0x"}, 0},
    {"a step adds to model data", "*BOUNDARY\n10, 1\n" + frequency + "*BOUNDARY\n7, 2\n" + end, {"0x", "1y"}, 0},
    {"OP=MOD says the same", "*BOUNDARY\n10, 1\n" + frequency + "*BOUNDARY, OP=MOD\n7, 2\n" + end, {"0x", "1y"}, 0},
    {"OP=NEW removes model data", "*BOUNDARY\n10, 1\n" + frequency + "*BOUNDARY, op = new\n7, 2\n" + end, {"1y"}, 0},
    {"a step inherits", "*STEP\n*STATIC\n*BOUNDARY\n10, 1\n" + end + frequency + end, {"0x"}, 0},
    {"OP=NEW removes what a step inherits",
     "*STEP\n*STATIC\n*BOUNDARY\n10, 1, 3\n50, 2\n" + end + frequency + "*BOUNDARY, OP=NEW\n10, 1, 3\n" + end,
     {"0x", "0y", "0z"},
     0},
    {"OP=NEW counts at the first of a step",
     "*BOUNDARY\n50, 1\n" + frequency + "*BOUNDARY, OP=NEW\n10, 1\n*BOUNDARY, OP=NEW\n7, 2\n" + end,
     {"0x", "1y"},
     0},
    {"OP=NEW after one without it is as in CalculiX",
     "*BOUNDARY\n50, 1\n" + frequency + "*BOUNDARY\n10, 1\n*BOUNDARY, OP=NEW\n7, 2\n" + end,
     {"0x", "1y", "4x"},
     1},
    {"later steps do not count",
     frequency + "*BOUNDARY\n10, 1\n" + end + "*STEP\n*STATIC\n*BOUNDARY\n7, 2\n" + end,
     {"0x"},
     0},
    {"the first of two frequency steps counts",
     frequency + "*BOUNDARY\n10, 1\n" + end + frequency + "*BOUNDARY, OP=NEW\n7, 2\n" + end,
     {"0x"},
     1},
    {"two frequency steps of the same supports",
     frequency + "*BOUNDARY\n10, 1, 2\n" + end + frequency + "*BOUNDARY, OP=NEW\n10, 2\n10, 1\n" + end,
     {"0x", "0y"},
     0},
    {"without a frequency step the last one counts",
     "*STEP\n*STATIC\n*BOUNDARY\n10, 1\n" + end + "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\n7, 2\n" + end,
     {"1y"},
     1},
    {"without a step the model data count", "*BOUNDARY\n10, 1\n7, 2\n", {"0x", "1y"}, 0},
    {"FIXED and velocities of zero hold",
     frequency + "*BOUNDARY, FIXED\n10, 1\n*BOUNDARY, TYPE=VELOCITY\n7, 2, 2, 0.\n" + end,
     {"0x", "1y"},
     0},
    {"a displacement of a frequency step holds",
     "*STEP\n*STATIC\n*BOUNDARY\n10, 1, 1, .5\n" + end + frequency + end,
     {"0x"},
     1},
    {"one that is replaced is not asked about",
     "*STEP\n*STATIC\n*BOUNDARY\n10, 1, 1, .5\n" + end + frequency + "*BOUNDARY, OP=NEW\n7, 2\n" + end,
     {"1y"},
     0}};

TEST(ReadInpSteps, SupportsOfTheFrequencyStepCount) {
  for (const auto& steps : cases) {
    SCOPED_TRACE(steps.what);
    const auto mesh = read_text("a.inp", deck(steps.deck));
    EXPECT_EQ(held(mesh), steps.held);
    EXPECT_EQ(mesh.notes.size(), steps.notes);
  }
}

TEST(ReadInpSteps, TellWhichOfUnequalSupportsCount) {
  const auto mesh =
      read_text("a.inp", deck(frequency + "*BOUNDARY\n10, 1\n" + end + frequency + "*BOUNDARY\n7, 2\n" + end));
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_NE(mesh.notes[0].find("a.inp:36: "), std::string::npos) << mesh.notes[0];
  EXPECT_NE(mesh.notes[0].find("first frequency step"), std::string::npos) << mesh.notes[0];
}

TEST(ReadInpSteps, RefuseAnotherOperation) {
  EXPECT_NE(error_of("a.inp", deck(frequency + "*BOUNDARY, OP=OLD\n10, 1\n")).find("a.inp:39: "), std::string::npos);
}

const std::string pull = "*CLOAD\n50, 3, 1e4\n";

TEST(ReadInpSteps, ThatStartFromAStressAreRefused) {
  const auto stressed = [](const std::string& first, const std::string& second) {
    return deck("*BOUNDARY\n10, 1, 3\n" + first + "*STATIC\n" + pull + end + second + "*FREQUENCY\n3\n" + end);
  };
  const auto linear = stressed("*STEP\n", "*STEP, PERTURBATION\n");
  EXPECT_NE(error_of("a.inp", linear).find("a.inp:43: *STEP, PERTURBATION"), std::string::npos);
  EXPECT_EQ(read_text("a.inp", linear, {"PERTURBATION"}).notes.size(), 1u);
  const auto large = stressed("*STEP, NLGEOM\n", "*STEP\n");
  EXPECT_NE(error_of("a.inp", large).find("a.inp:38: *STEP, NLGEOM"), std::string::npos);
  EXPECT_EQ(read_text("a.inp", large, {"NLGEOM"}).notes.size(), 1u);
  EXPECT_EQ(read_text("a.inp", large, {"STEP"}).notes.size(), 1u);
  const auto spinning =
      deck("*STEP, PERTURBATION\n*FREQUENCY\n3\n*DLOAD\nlower, CENTRIF, 1e6, 0.,0.,0., 0.,0.,1.\n" + end);
  EXPECT_NE(error_of("a.inp", spinning).find("a.inp:36: *STEP, PERTURBATION"), std::string::npos);
}

TEST(ReadInpSteps, ThatStartFromNoStressAreRead) {
  for (const auto& steps :
       {"*STEP\n*STATIC\n" + pull + end + frequency + end, "*STEP, PERTURBATION\n*FREQUENCY\n3\n" + end,
        "*STEP, NLGEOM\n*STATIC\n" + end + frequency + end,
        "*STEP, NLGEOM=NO\n*STATIC\n" + pull + end + frequency + end,
        frequency + end + "*STEP, NLGEOM\n*STATIC\n" + pull + end})
    EXPECT_TRUE(read_text("a.inp", deck("*BOUNDARY\n10, 1, 3\n" + steps)).notes.empty()) << steps;
}

TEST(ReadInpSteps, PrescribeDisplacementsOnlyWhereAFrequencyStepHoldsThem) {
  const auto moved = deck("*STEP\n*STATIC\n*BOUNDARY\n10, 1, 1, .5\n" + end);
  EXPECT_NE(error_of("a.inp", moved).find("a.inp:39: a prescribed displacement"), std::string::npos);
  const auto mesh = read_text("a.inp", moved, {"BOUNDARY"});
  EXPECT_EQ(held(mesh), (std::set<std::string>{"0x"}));
  EXPECT_EQ(mesh.notes.size(), 1u);
  EXPECT_NE(error_of("a.inp", deck("*STEP\n*BOUNDARY, SUBMODEL, STEP=1\nfeet, 1, 3\n" + end)).find("prescribed"),
            std::string::npos);
}

TEST(ReadInpSteps, ManyWithManySupportsTakeTimeInProportion) {
  std::string steps = "*BOUNDARY\n";
  for (int i = 0; i < 20'000; ++i) steps += "Nall, 1\n";
  for (int i = 0; i < 20'000; ++i) steps += "*STEP\n*BOUNDARY, OP=NEW\nNall, 2\n";
  const auto mesh = read_text("a.inp", deck(steps));
  EXPECT_EQ(mesh.supports.size(), 1u);
  EXPECT_EQ(mesh.supports[0].held, (std::array{false, true, false}));
}

}  // namespace
}  // namespace ritz::readers::testing
