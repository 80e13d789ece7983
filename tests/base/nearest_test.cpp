#include "ritz/base/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ritz {

TEST(Nearest, DistanceCountsEdits) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("same", "SAME"), 0u);
  EXPECT_EQ(edit_distance("-moeds", "-modes"), 1u);  // a swap of neighbours is one slip
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);
}

TEST(Nearest, PicksTheClosestAndTheFirstOfEquals) {
  const std::array<std::string_view, 4> keys = {"step", "end", "integrator", "steps"};
  EXPECT_EQ(nearest("stpe", keys), "step");
  EXPECT_EQ(nearest("integrater", keys), "integrator");
  EXPECT_EQ(nearest("ent", keys), "end");
  EXPECT_EQ(nearest("b", std::vector<std::string>{"a", "c"}), "a");
}

TEST(Hint, GuessesWhatIsAlikeAndListsTheRest) {
  const std::vector<std::string> damping = {"alpha", "beta"};
  EXPECT_EQ(hint("bta", damping), "; did you mean 'beta'? There are 'alpha' and 'beta'");
  EXPECT_EQ(hint("zeta", damping), "; there are 'alpha' and 'beta'");  // a ratio is not a factor of K
  EXPECT_EQ(hint("friction", damping), "; there are 'alpha' and 'beta'");
  EXPECT_EQ(hint("tpi", std::vector<std::string>{"tip"}), "; did you mean 'tip'?");
  EXPECT_EQ(hint("bolts", std::vector<std::string>{"tip"}), "; there is 'tip'");
  EXPECT_EQ(hint("bolts", std::vector<std::string>{}), "");
}

TEST(Hint, OfManyGuessesOnlyWhatIsAlike) {
  std::vector<std::string> many;
  for (int i = 0; i < 20; ++i) many.push_back("surface_" + std::to_string(i));
  EXPECT_EQ(hint("surfce_7", many), "; did you mean 'surface_7'?");
  const auto unlike = hint("lugs", many);
  EXPECT_EQ(unlike.find("did you mean"), unlike.npos);
  EXPECT_NE(unlike.find("'surface_11' and 8 others"), unlike.npos) << unlike;
}

using Meant = std::vector<std::string>;

TEST(MeantBy, IsOneOfFewSlips) {
  const Meant options = {"timing", "export", "reuse", "modes"};
  for (const auto* word : {"modse", "mdoes", "Modes", "mods", "omdes"})
    EXPECT_EQ(meant_by(word, options), Meant{"modes"});
  for (const auto* word : {"damping", "support", "reduce", "rank", "k", ""})
    EXPECT_EQ(meant_by(word, options), Meant{}) << word;
}

TEST(MeantBy, IsAWordThatBeginsOrEndsWithTheOneGiven) {
  const std::vector<std::string> options = {"modes", "material_young", "material_density"};
  EXPECT_EQ(meant_by("young", options), Meant{"material_young"});
  EXPECT_EQ(meant_by("material", options), (Meant{"material_young", "material_density"}));
  EXPECT_EQ(meant_by("num_modes", options), Meant{"modes"});
  EXPECT_EQ(meant_by("pressure", options), Meant{});
  EXPECT_EQ(meant_by("force", Meant{"newton_force_iteration"}), Meant{});
  EXPECT_EQ(meant_by("mod", Meant{"model_of_it"}), Meant{});  // three letters occur anywhere
  EXPECT_EQ(meant_by("left", Meant{"left_1", "left_2", "left_3", "left_4", "left_5"}), Meant{});
  EXPECT_EQ(guess("left", Meant{"left_up", "left_low", "left_up"}), "; did you mean 'left_up' or 'left_low'?");
}

TEST(Nearest, OfNothingIsEmpty) { EXPECT_EQ(nearest("x", std::vector<std::string>{}), ""); }

}  // namespace ritz
