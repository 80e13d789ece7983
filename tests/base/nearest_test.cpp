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

TEST(Nearest, OfNothingIsEmpty) { EXPECT_EQ(nearest("x", std::vector<std::string>{}), ""); }

}  // namespace ritz
