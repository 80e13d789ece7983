// The grammar of -fix.
#include "ritz/config/supports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Mask = std::array<bool, 3>;

constexpr Mask whole = {true, true, true};
constexpr double infinite = std::numeric_limits<double>::infinity();

std::string name(const mesh::Fixed& fixed) { return std::get<std::string>(fixed.where); }
mesh::Region3 box(const mesh::Fixed& fixed) { return std::get<mesh::Region3>(fixed.where); }

TEST(Fix, NamesSets) {
  const auto fixed = parse_supports("foot,left side", {}).fixed;
  ASSERT_EQ(fixed.size(), 2u);
  EXPECT_EQ(name(fixed[0]), "foot");
  EXPECT_EQ(fixed[0].fixed, whole);
  EXPECT_EQ(name(fixed[1]), "left side");
  EXPECT_EQ(fixed[1].text, "foot,left side");
}

TEST(Fix, NamesComponents) {
  const auto fixed = parse_supports("foot:z,left:xy,right:zyx,top", {}).fixed;
  ASSERT_EQ(fixed.size(), 4u);
  EXPECT_EQ(name(fixed[0]), "foot");
  EXPECT_EQ(fixed[0].fixed, (Mask{false, false, true}));
  EXPECT_EQ(fixed[1].fixed, (Mask{true, true, false}));
  EXPECT_EQ(fixed[2].fixed, whole);
  EXPECT_EQ(fixed[3].fixed, whole);
}

TEST(Fix, TakesBoxesInTheUnitsOfTheMesh) {
  const auto fixed = parse_supports("box:-1,2,-3,4,0,0.5", mesh::parse_units("mm-t-s")).fixed;
  ASSERT_EQ(fixed.size(), 1u);
  EXPECT_TRUE(box(fixed[0]).low.isApprox(Eigen::Vector3d(-1e-3, -3e-3, 0)));
  EXPECT_TRUE(box(fixed[0]).high.isApprox(Eigen::Vector3d(2e-3, 4e-3, 0.5e-3)));
  EXPECT_EQ(fixed[0].fixed, whole);
}

TEST(Fix, MixesBoxesAndSets) {
  const auto fixed = parse_supports("foot:x,box:-inf,inf,0,0,-inf,inf:yz,top", {}).fixed;
  ASSERT_EQ(fixed.size(), 3u);
  EXPECT_EQ(box(fixed[1]).low, Eigen::Vector3d(-infinite, 0, -infinite));
  EXPECT_EQ(box(fixed[1]).high, Eigen::Vector3d(infinite, 0, infinite));
  EXPECT_EQ(fixed[1].fixed, (Mask{false, true, true}));
  EXPECT_EQ(name(fixed[2]), "top");
}

TEST(Fix, NamesVegaLists) {
  const auto supports = parse_supports("a/b.bou:y,foot", {});
  ASSERT_EQ(supports.fixed.size(), 2u);
  EXPECT_EQ(name(supports.fixed[0]), "a/b.bou");
  EXPECT_EQ(supports.fixed[0].fixed, (Mask{false, true, false}));
  EXPECT_EQ(supports.vertex_lists, (std::vector<std::filesystem::path>{"a/b.bou"}));
}

TEST(Fix, KeepsBothReadingsOfAnEndLikeComponents) {
  const auto fixed = parse_supports("side:x,nset:foot,foot:xw", {}).fixed;
  ASSERT_EQ(fixed.size(), 3u);
  EXPECT_EQ(name(fixed[0]), "side");
  EXPECT_EQ(fixed[0].fixed, (Mask{true, false, false}));
  EXPECT_EQ(fixed[0].whole_name, "side:x");
  EXPECT_EQ(name(fixed[1]), "nset:foot");
  EXPECT_EQ(name(fixed[2]), "foot:xw");  // no components: a name, if the mesh has it
  EXPECT_EQ(fixed[2].fixed, whole);
  EXPECT_FALSE(fixed[1].whole_name || fixed[2].whole_name);
}

TEST(Fix, TakesNamesInQuotesAsTheyAre) {
  const auto supports = parse_supports(R"("side:x":yz,"a, b",foot,"none","box:1":z)", {});
  const auto& fixed = supports.fixed;
  ASSERT_EQ(fixed.size(), 5u);
  EXPECT_EQ(name(fixed[0]), "side:x");
  EXPECT_EQ(fixed[0].fixed, (Mask{false, true, true}));
  EXPECT_EQ(name(fixed[1]), "a, b");
  EXPECT_EQ(fixed[1].fixed, whole);
  EXPECT_EQ(name(fixed[2]), "foot");
  EXPECT_EQ(name(fixed[3]), "none");
  EXPECT_EQ(name(fixed[4]), "box:1");
  EXPECT_EQ(fixed[4].fixed, (Mask{false, false, true}));
  for (const auto& one : fixed) EXPECT_FALSE(one.whole_name);
}

TEST(Fix, MayHoldNothing) {
  const auto supports = parse_supports("none", {});
  EXPECT_TRUE(supports.fixed.empty());
  EXPECT_TRUE(supports.vertex_lists.empty());
}

TEST(Fix, SaysWhatIsWrong) {
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{{"\"foot", "not closed"},
                                                                                  {"foot,,top", "empty"},
                                                                                  {",", "empty"},
                                                                                  {"none,foot", "'none'"},
                                                                                  {"box:1,2,3", "six numbers"},
                                                                                  {"box:0,1,0,1,0,one", "'one'"},
                                                                                  {"box:0,1,0,nan,0,1", "'nan'"},
                                                                                  {"box:1,0,0,1,0,1", "inside out"},
                                                                                  {"box:0,1,0,1,0,1:w", "'w'"},
                                                                                  {"box:,,,,,", "not a number"},
                                                                                  {":xyz", "empty"},
                                                                                  {"\"\"", "empty"},
                                                                                  {"\"a\"b", "follows a name"},
                                                                                  {"\"a\":w", "follows a name"}})
    EXPECT_THAT([&] { parse_supports(text, {}); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("-fix " + text), HasSubstr(why))))
        << text;
}

}  // namespace
}  // namespace ritz::config
