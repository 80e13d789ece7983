// The regions of overlapping volumes, and of those that are left without cells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Region& region_of(const FileMesh& mesh, std::size_t cell) {
  return mesh.regions.at(static_cast<std::size_t>(mesh.cell_regions.at(cell)));
}

// The two tetrahedra as version 2.2 with the groups of each: a cell is repeated for each group.
std::string msh22_groups(const std::vector<int>& lower, const std::vector<int>& upper) {
  std::string cells;
  int id = 5;
  for (const int group : lower) cells += std::to_string(id++) + " 4 2 " + std::to_string(group) + " 1 10 7 30 4000\n";
  for (const int group : upper) cells += std::to_string(id++) + " 4 2 " + std::to_string(group) + " 2 7 30 4000 50\n";
  auto text = with(msh22_text(), "5 4 2 1 1 10 7 30 4000\n6 4 3 2 2 0 7 30 4000 50\n", cells);
  return with(text, "$Elements\n4", "$Elements\n" + std::to_string(2 + lower.size() + upper.size()));
}

TEST(Regions, OfAVolumeInsideAnotherAreTheSmallerOnes) {
  for (const auto& upper : {std::vector{1, 2}, std::vector{2, 1}}) {
    const auto mesh = read_text("a.msh", msh22_groups({1}, upper));
    EXPECT_EQ(region_of(mesh, 0).name, "lower");
    EXPECT_THAT(region_of(mesh, 0).parts, IsEmpty());
    EXPECT_EQ(region_of(mesh, 1).name, "the upper one");
    EXPECT_THAT(region_of(mesh, 1).parts, ElementsAre("lower"));
    EXPECT_EQ(region_of(mesh, 1).overlap, Overlap::nested);
    EXPECT_EQ(find_set(mesh, "lower")->vertices.size(), 5u);
    EXPECT_EQ(find_set(mesh, "the upper one")->vertices.size(), 4u);
  }
}

TEST(Regions, OfEntitiesWithSeveralTagsAreTheSame) {
  // Version 4.1: the upper volume is in groups 2 and 9, the lower in 1 and 9.
  const auto text = with(msh41_text(), "1 0 0 0 1 1 1 1 1 1 1 \n", "1 0 0 0 1 1 1 2 9 1 1 1 \n");
  const auto mesh = read_text("a.msh", text);
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"lower", "the upper one"}));
  EXPECT_THAT(region_of(mesh, 0).parts, ElementsAre("9"));
  EXPECT_THAT(region_of(mesh, 1).parts, ElementsAre("9"));
}

TEST(Regions, OfVolumesOfTheSameCellsHaveBothNames) {
  const auto mesh = read_text("a.msh", msh41_text());  // the upper volume is groups 2 and 9
  EXPECT_EQ(region_of(mesh, 1).name, "the upper one");
  EXPECT_THAT(region_of(mesh, 1).parts, ElementsAre("the upper one", "9"));
  EXPECT_EQ(region_of(mesh, 1).overlap, Overlap::crossing);
}

TEST(Regions, OfVolumesThatCrossAreNamedByBoth) {
  auto text = with(msh22_groups({1}, {1, 2}), "$Nodes\n5\n", "$Nodes\n6\n60 2 2 2\n");
  text = with(with(text, "$Elements\n5", "$Elements\n6"), "$EndElements", "90 4 2 2 3 30 4000 50 60\n$EndElements");
  const auto mesh = read_text("a.msh", text);
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"lower", "lower & the upper one", "the upper one"}));
  EXPECT_EQ(region_of(mesh, 1).overlap, Overlap::crossing);
  EXPECT_THAT(region_of(mesh, 1).parts, ElementsAre("lower", "the upper one"));
}

TEST(Regions, OfOneNameAreOne) {
  const auto mesh = read_text("a.msh", with(msh22_text(), "\"the upper one\"", "\"lower\""));
  EXPECT_EQ(mesh.regions.size(), 1u);
  EXPECT_EQ(find_set(mesh, "lower")->vertices.size(), 5u);
}

TEST(Regions, ThatLoseAllTheirCellsAreLeftOut) {
  const auto veg = with(veg_text(), "*REGION\nlower, steel\n", "*REGION\nlower, rubber\n*REGION\nlower, steel\n");
  const auto mesh = read_text("a.veg", veg);
  ASSERT_EQ(mesh.regions.size(), 2u);
  EXPECT_EQ(region_of(mesh, 0).material.young, 2e11);
}

TEST(Regions, OfCellsWithoutOneHaveANameOfTheirOwn) {
  auto text = with(msh22_text(), "5 4 2 1 1", "5 4 2 0 1");
  text = with(text, "\"the upper one\"", "\"default\"");
  EXPECT_EQ(cell_region_names(read_text("a.msh", text)), (std::vector<std::string>{"default_", "default"}));
}

TEST(Materials, OfAnotherLawOfVegasAreLeftToTheOptions) {
  for (const std::string law : {"ORTHOTROPIC_N1, 7800, 1e10, 1e9, 1e9, .3", "ORTHOTROPIC_N1G1, 7800, 1, 1, 1, .3, 1"}) {
    const auto mesh = read_text("a.veg", with(veg_text(), "ENU, 7800, 2e11, 0.3", law));
    const auto& material = region_of(mesh, 0).material;
    EXPECT_EQ(material.density, 7800);
    EXPECT_FALSE(material.young || material.poisson);
    EXPECT_NE(material.unread_law.find("a.veg:16: material law " + law.substr(0, law.find(','))), std::string::npos);
  }
}

TEST(Keywords, ThatVegaDoesNotHaveMayBeIgnored) {
  const auto mesh = read_text("a.veg", with(veg_text(), "*REGION\n", "*DAMPERS, 3\n1 2 3\n*REGION\n"), {"DAMPERS"});
  expect_two_tets(mesh, "lower", "upper", "");
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_NE(mesh.notes[0].find("*DAMPERS"), std::string::npos);
}

}  // namespace
}  // namespace ritz::readers::testing
