// Sets that share a name, and cells that only carry a set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Index> vertices(const FileMesh& mesh, const std::string& name) {
  const auto* const set = find_set(mesh, name);
  EXPECT_TRUE(set) << name;
  return set ? set->vertices : std::vector<Index>();
}

TEST(SharedNames, OfAnInpFileKeepTheirKindsApart) {
  // As Abaqus/CAE writes a picked face: its nodes, the elements beside them, the faces. Names do not mind capitals.
  const auto mesh = read_text("a.inp", inp_with("*ELSET, ELSET=Fix\n5\n*NSET, NSET=FIX\n10, 7\n*NSET, NSET=fix\n30\n"
                                                "*SURFACE, NAME=fix\nupper, S3\n*NSET, NSET=alone\n10\n"));
  EXPECT_FALSE(find_set(mesh, "Fix"));
  EXPECT_EQ(vertices(mesh, "elset:Fix"), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(vertices(mesh, "nset:Fix"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices(mesh, "surface:Fix"), (std::vector<Index>{2, 3, 4}));
  EXPECT_EQ(find_set(mesh, "surface:Fix")->faces.size(), 1u);
  EXPECT_EQ(vertices(mesh, "alone"), (std::vector<Index>{0}));
  EXPECT_THAT(mesh.notes, ElementsAre(AllOf(HasSubstr("'nset:Fix', 'elset:Fix' or 'surface:Fix'"),
                                            HasSubstr("means 'nset:Fix' to supports, forces and probes"),
                                            HasSubstr("means 'surface:Fix' to pressure"))));
}

TEST(SharedNames, AreNotedOnceAFile) {
  const auto mesh = read_text("a.inp", inp_with("*NSET, NSET=upper\n10\n*NSET, NSET=lower\n50\n"));
  EXPECT_EQ(vertices(mesh, "nset:upper"), (std::vector<Index>{0}));
  EXPECT_EQ(vertices(mesh, "elset:upper"), (std::vector<Index>{1, 2, 3, 4}));
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"Lower", "upper"}));
  EXPECT_THAT(mesh.notes, ElementsAre(AllOf(HasSubstr("1 other name"), HasSubstr("is not clear to pressure"))));
  EXPECT_TRUE(read_text("a.inp", inp_text()).notes.empty());
}

TEST(SharedNames, OfGmshAreToldApartByTheirDimension) {
  const auto text = with(msh22_text(), "2 7 \"bottom\"\n3 1 \"lower\"\n", "2 7 \"same\"\n3 1 \"same\"\n");
  const auto mesh = read_text("a.msh", text);
  EXPECT_EQ(cell_region_names(mesh)[0], "same");
  EXPECT_EQ(vertices(mesh, "surface:same"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices(mesh, "volume:same"), (std::vector<Index>{0, 1, 2, 3}));
  auto curve = with(msh22_text(), "3\n2 7 \"bottom\"\n", "4\n1 3 \"bottom\"\n2 7 \"bottom\"\n");
  curve = with(curve, "1 15 2 0 1 10\n", "1 1 2 3 1 7 50\n");
  EXPECT_EQ(vertices(read_text("a.msh", curve), "curve:bottom"), (std::vector<Index>{1, 4}));
  EXPECT_EQ(vertices(read_text("a.msh", curve), "surface:bottom"), (std::vector<Index>{0, 1, 2}));
}

TEST(SharedNames, OfVtuTellPointsFromCells) {
  const auto mesh = read_text("a.vtu", with(vtu_text(), "\"feet\"", "\"7\""));
  EXPECT_EQ(vertices(mesh, "points:7"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices(mesh, "surface:7"), (std::vector<Index>{0, 1, 2}));
  const auto solid = read_text("a.vtu", with(vtu_text(), "\"feet\"", "\"2\""));
  EXPECT_EQ(vertices(solid, "points:2"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices(solid, "volume:2"), (std::vector<Index>{1, 2, 3, 4}));
  EXPECT_EQ(cell_region_names(solid)[1], "2");
}

TEST(SharedNames, MustNotBeTheNameOfAnother) {
  EXPECT_THAT(error_of("a.inp", inp_with("*NSET, NSET=upper\n10\n*NSET, NSET=nset:upper\n7\n")),
              HasSubstr("'nset:upper'"));
}

TEST(CellsOfSets, MayNameAVertexTwice) {
  const auto line = with(msh22_text(), "1 15 2 0 1 10\n", "1 1 2 9 1 7 7\n");
  EXPECT_EQ(vertices(read_text("a.msh", line), "9"), (std::vector<Index>{1}));
  const auto triangle = with(msh22_text(), "2 2 2 7 1 10 30 7\n", "2 2 2 7 1 10 30 30\n");
  const auto mesh = read_text("a.msh", triangle);
  EXPECT_EQ(vertices(mesh, "bottom"), (std::vector<Index>{0, 2}));
  EXPECT_TRUE(find_set(mesh, "bottom")->faces.empty());
  const auto beam =
      with(inp_text(), "*MATERIAL, NAME=Steel", "*ELEMENT, TYPE=T3D2, ELSET=line\n99, 50, 50\n*MATERIAL, NAME=Steel");
  EXPECT_EQ(vertices(read_text("a.inp", beam), "line"), (std::vector<Index>{4}));
}

TEST(CellsOfSets, ThatCollapseToATriangleAreOne) {
  const auto text = with(msh22_text(), "2 2 2 7 1 10 30 7\n", "2 3 2 7 1 10 30 30 7\n");
  const auto mesh = read_text("a.msh", text);
  expect_two_tets(mesh, "lower", "the upper one", "bottom");
}

}  // namespace
}  // namespace ritz::readers::testing
