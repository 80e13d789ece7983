#include "ritz/base/set_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ritz {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

using Names = std::vector<std::string>;

std::string vertices(const Names& names, const std::string& asked) {
  return resolve_set(names, asked, SetUse::vertices, "the mesh");
}

std::string surface(const Names& names, const std::string& asked) {
  return resolve_set(names, asked, SetUse::surface, "the mesh");
}

TEST(SetName, OfOneSetIsThatSetForEveryUse) {
  const Names names = {"elset:FIX", "FIX", "grip"};
  EXPECT_EQ(vertices(names, "FIX"), "FIX");
  EXPECT_EQ(surface(names, "FIX"), "FIX");
  EXPECT_EQ(surface(names, "grip"), "grip");
}

TEST(SetName, OfSeveralKindsMeansWhatTheUseTakes) {
  const Names abaqus = {"elset:FIX", "nset:FIX", "surface:FIX"}, vtk = {"volume:5", "points:5", "surface:5"};
  EXPECT_EQ(vertices(abaqus, "FIX"), "nset:FIX");
  EXPECT_EQ(surface(abaqus, "FIX"), "surface:FIX");
  EXPECT_EQ(vertices(vtk, "5"), "points:5");
  EXPECT_EQ(surface(vtk, "5"), "surface:5");
}

TEST(SetName, MayNameItsKind) {
  const Names names = {"elset:FIX", "nset:FIX"};
  EXPECT_EQ(vertices(names, "elset:FIX"), "elset:FIX");
  EXPECT_EQ(surface(names, "nset:FIX"), "nset:FIX");
}

TEST(SetName, OfABodyGivesWayToAPartOfItsBoundary) {
  EXPECT_EQ(vertices({"volume:top", "surface:top"}, "top"), "surface:top");
  EXPECT_EQ(vertices({"volume:top", "curve:top"}, "top"), "curve:top");
  EXPECT_EQ(vertices({"volume:top"}, "top"), "volume:top");
}

TEST(SetName, ThatIsMisspeltIsComparedWithNamesAndWithKinds) {
  const Names names = {"elset:FIX", "nset:FIX", "BAR", "TIP"};
  const auto misspelt = [&](const std::string& asked) { return [&names, asked] { vertices(names, asked); }; };
  EXPECT_THAT(misspelt("FXI"), ThrowsMessage<InputError>(HasSubstr("did you mean 'FIX'?")));
  EXPECT_THAT(misspelt("FIX:q"), ThrowsMessage<InputError>(HasSubstr("did you mean 'FIX'?")));
  EXPECT_THAT(misspelt("nset:FIZ"), ThrowsMessage<InputError>(HasSubstr("did you mean 'nset:FIX'?")));
}

TEST(SetName, ThatStaysAmbiguousIsRefused) {
  EXPECT_THAT(
      [] {
        vertices({"elset:FIX", "surface:FIX"}, "FIX");
      },
      ThrowsMessage<InputError>("the mesh has several sets 'FIX'; say which: 'elset:FIX' or 'surface:FIX'"));
  EXPECT_THAT([] { surface({"nset:FIX", "elset:FIX"}, "FIX"); }, ThrowsMessage<InputError>(HasSubstr("'nset:FIX' or")));
  EXPECT_THAT(
      [] {
        vertices({"point:a", "curve:a", "surface:a", "volume:a"}, "a");
      },
      ThrowsMessage<InputError>(HasSubstr("'point:a', 'curve:a' or 'surface:a'")));
}

TEST(SetName, ThatNoSetHasSuggestsAnother) {
  EXPECT_THAT(
      [] {
        vertices({"left", "right"}, "lfet");
      },
      ThrowsMessage<InputError>(HasSubstr("no set 'lfet'; did you mean 'left'?")));
  EXPECT_THAT([] { vertices({}, "left"); }, ThrowsMessage<InputError>(HasSubstr("no named sets")));
  EXPECT_THAT([] { vertices({"left", "right"}, "nset:left"); }, ThrowsMessage<InputError>(HasSubstr("write 'left'")));
  EXPECT_THAT(meant_sets({"left"}, "right", SetUse::vertices), IsEmpty());
  EXPECT_THAT(meant_sets({"elset:a", "surface:a"}, "a", SetUse::vertices), ElementsAre("elset:a", "surface:a"));
}

}  // namespace
}  // namespace ritz
