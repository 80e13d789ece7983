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
  EXPECT_EQ(hint("zeta", damping), "; did you mean 'beta'? There are 'alpha' and 'beta'");
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

TEST(MeantBy, IsAWordThatContainsTheOneGiven) {
  const std::vector<std::string> options = {"modes", "material_young", "material_density"};
  EXPECT_EQ(meant_by("young", options), "material_young");
  EXPECT_EQ(meant_by("moeds", options), "modes");
  EXPECT_EQ(meant_by("pressure", options), "");
  EXPECT_EQ(meant_by("mod", std::vector<std::string>{"a_model_of_it"}), "");  // three letters occur anywhere
}

TEST(Nearest, OfNothingIsEmpty) { EXPECT_EQ(nearest("x", std::vector<std::string>{}), ""); }

}  // namespace ritz
