// Sections of .msh files: those that are skipped, whatever their data holds, those that are not, and how they end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::HasSubstr;

void expect_the_mesh(const std::string& bytes) {
  expect_two_tets(read_text("a.msh", bytes), "lower", "the upper one", "bottom");
}

std::string without_breaks(std::string text) {
  for (const std::string end : {"$EndNodes", "$EndElements", "$EndEntities", "$EndMeshFormat"})
    if (const auto at = text.find("\n" + end); at != text.npos) text.erase(at, 1);
  return text;
}

// A section of results, as TetWild and PyMesh write it: no line break before its end.
std::string data_section(const std::string& name, const std::string& values, const std::string& tags = "3\n0\n1\n2\n") {
  return "$" + name + "\n1\n\"quality\"\n1\n0.5\n" + tags + values + "$End" + name + "\n";
}

std::string entry(int id, const std::string& eight_bytes) { return Bytes().add(id).text(eight_bytes).str(); }

// Values whose bytes are line breaks and marks of an end.
const std::string awkward = entry(1, "$EndEle\n") + entry(2, "\n$Nodes\n");

TEST(MshSections, NeedNoLineBreakAtTheEndOfBinaryData) {
  for (const auto& binary : {msh22_binary(), msh41_binary()}) {
    expect_the_mesh(without_breaks(binary));
    expect_the_mesh(binary + data_section("ElementData", entry(1, "01234567") + entry(2, "abcdefgh")));
    expect_the_mesh(without_breaks(binary) + data_section("NodeData", awkward));
  }
}

TEST(MshSections, OfDataMayHoldTheirOwnEnd) {
  const auto mark = std::string("$EndElementData\n$Nodes\n\0", 24);  // three numbers of eight bytes
  const auto values = Bytes().add(1).text(mark).add(2).text(mark).str();
  expect_the_mesh(msh22_binary() + data_section("ElementData", values, "3\n0\n3\n2\n"));
  expect_the_mesh(
      with(msh41_binary(), "$Nodes\n",
           data_section("ElementNodeData", Bytes().add(1).add(3).text(mark).add(2).add(0).str()) + "$Nodes\n"));
}

TEST(MshSections, OfDataInAnotherLayoutEndAtTheirMark) {
  const auto odd = "$NodeData\n" + std::string("\0\1\n$Nodes\n\n $EndNodeData and more\n", 34) + "$EndNodeData\n";
  expect_the_mesh(with(msh41_binary(), "$Nodes\n", odd + "$Nodes\n"));
  expect_the_mesh(msh22_binary() + odd);
}

TEST(MshSections, ThatSayNothingOfTheBodyAreSkipped) {
  for (const char* const name : {"Comments", "NodeData", "ElementData", "ElementNodeData", "InterpolationScheme",
                                 "Periodic", "GhostElements", "Parametrizations"}) {
    const auto section = "$" + std::string(name) + "\n3 4\nanything\n$End" + name + "\n";
    for (const auto& text : {msh22_text(), msh41_text(), msh22_binary(), msh41_binary()}) {
      expect_the_mesh(with(text, "$EndPhysicalNames\n", "$EndPhysicalNames\n" + section));
      expect_the_mesh(text + section);
    }
  }
}

TEST(MshSections, ThatRitzDoesNotKnowAreRefusedUnlessTheyAreIgnored) {
  for (const auto& good : {msh22_text(), msh41_binary()}) {
    const auto text = good + "$Stiffeners\n1\n2 3\n$EndStiffeners\n";
    EXPECT_THAT(error_of("a.msh", text),
                HasSubstr("$Stiffeners is not a section that ritz knows; '-ignore STIFFENERS'"));
    const auto mesh = read_text("a.msh", text, {"STIFFENERS"});
    expect_two_tets(mesh, "lower", "the upper one", "bottom");
    ASSERT_EQ(mesh.notes.size(), 1u);
    EXPECT_THAT(mesh.notes[0], HasSubstr("$Stiffeners"));
  }
}

TEST(MshSections, WithoutAnEndAreRefused) {
  EXPECT_THAT(error_of("a.msh", msh22_binary() + "$ElementData\n1\n\"q\"\n"), HasSubstr("$ElementData has no end"));
  EXPECT_THAT(error_of("a.msh", msh41_text() + "$NodeData\n1\nx $EndNodeData\n"), HasSubstr("$NodeData has no end"));
}

TEST(MshSections, OfEntitiesInAbsurdlyManyGroupsAreRefused) {
  std::string tags = "400";
  for (int tag = 1; tag <= 400; ++tag) tags += " " + std::to_string(tag);
  auto text = with(msh41_text(), "1 0 0 0 1 1 1 1 1 1 1 \n", "1 0 0 0 1 1 1 " + tags + " 1 1 \n");
  expect_consistent(read_text("a.msh", text));
  std::string cells;
  for (int cell = 0; cell < 30; ++cell) cells += std::to_string(100 + cell) + " 10 7 30 4000\n";
  text = with(with(text, "3 1 4 1\n5 10 7 30 4000\n", "3 1 4 30\n" + cells), "4 4 1 6", "4 33 1 200");
  EXPECT_THAT(error_of("a.msh", text), HasSubstr("more physical groups"));
}

}  // namespace
}  // namespace ritz::readers::testing
