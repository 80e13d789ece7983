// Sets: numbers that are not there, sets of sets, and lists that are out of proportion to the file.
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

TEST(ReadInpSets, DoWithoutNumbersThatAreNotThere) {
  const auto mesh = read_text(
      "a.inp", inp_with("*NSET, NSET=some\n10, 999,\n1000\n*NSET, NSET=none\n998\n*ELSET, ELSET=cells, GENERATE\n"
                        "105, 106\n6, 6\n*NSET, NSET=of_some\nsome\n"));
  EXPECT_EQ(find_set(mesh, "some")->vertices, (std::vector<Index>{0}));
  EXPECT_EQ(find_set(mesh, "of_some")->vertices, (std::vector<Index>{0}));
  EXPECT_EQ(find_set(mesh, "cells")->vertices, (std::vector<Index>{1, 2, 3, 4}));
  EXPECT_FALSE(find_set(mesh, "none"));
  ASSERT_EQ(mesh.notes.size(), 2u);
  EXPECT_NE(mesh.notes[0].find("a.inp:37: set 'some' names node 999"), std::string::npos) << mesh.notes[0];
  EXPECT_NE(mesh.notes[0].find("nor 2 others"), std::string::npos) << mesh.notes[0];
  EXPECT_NE(mesh.notes[1].find("a.inp:42: set 'cells' names element 105"), std::string::npos) << mesh.notes[1];
}

TEST(ReadInpSets, ThatHoldNothingAreToldWhereTheySupport) {
  const auto mesh = read_text("a.inp", inp_with("*NSET, NSET=none\n*BOUNDARY\nnone, 1, 3\n"));
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_NE(mesh.notes[0].find("a.inp:38: *BOUNDARY holds 'none'"), std::string::npos) << mesh.notes[0];
}

TEST(ReadInpSets, TakeOthersAsTheyStand) {
  const auto mesh = read_text("a.inp", inp_with("*NSET, NSET=a\n10\n*NSET, NSET=b\na, 7\n*NSET, NSET=a\n30, b\n"
                                                "*NSET, NSET=c\nb\n*NSET, NSET=b\na\n"));
  EXPECT_EQ(find_set(mesh, "a")->vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(find_set(mesh, "b")->vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(find_set(mesh, "c")->vertices, (std::vector<Index>{0, 1}));
}

TEST(ReadInpSets, JoinRangesThatOverlap) {
  std::string lines = "*NSET, NSET=odd, GENERATE\n7, 29, 2\n29, 51, 2\n10, 10, 1\n7, 7, 2\n1, 9, 2\n";
  EXPECT_EQ(find_set(read_text("a.inp", inp_with(lines)), "odd")->vertices, (std::vector<Index>{0, 1}));
  lines = "*NSET, NSET=even, GENERATE\n4, 30, 2\n32, 50, 2\n3990, 4010, 10\n";
  EXPECT_EQ(find_set(read_text("a.inp", inp_with(lines)), "even")->vertices, (std::vector<Index>{0, 2, 3, 4}));
}

TEST(ReadInpSets, OfSetsMakeRegionsWhereNumbersAreListed) {
  auto text = inp_text();
  text = text.substr(0, text.find("*ELSET, ELSET=both"));
  const auto all = read_text("a.inp", text + "*ELSET, ELSET=all\nlower, upper\n");
  EXPECT_EQ(cell_region_names(all), (std::vector<std::string>{"Lower", "upper"}));
  const auto listed = read_text("a.inp", text + "*ELSET, ELSET=one\n6\n*ELSET, ELSET=all\nlower, one\n");
  EXPECT_EQ(cell_region_names(listed), (std::vector<std::string>{"all", "one"}));
}

/// A grid of points, `count` of them, and one tetrahedron.
std::string cloud(int count) {
  std::string text = "*NODE, NSET=all\n";
  for (int i = 0; i < count; ++i)
    text += std::to_string(i + 1) + "," + std::to_string(i % 30) + "," + std::to_string(i / 30 % 30) + "," +
            std::to_string(i / 900) + "\n";
  return text + "*ELEMENT, TYPE=C3D4, ELSET=E\n1,1,2,31,901\n";
}

std::string repeated(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

TEST(ReadInpSets, OfRangesThatRepeatTakeNoMoreThanOne) {
  const auto ranges = repeated("1,20000,1\n", 30'000) + repeated("1,19999\n2,20000,2\n1,19998,3\n", 10'000);
  const auto mesh = read_text("a.inp", cloud(20'000) + "*NSET, NSET=A, GENERATE\n" + ranges);
  EXPECT_EQ(find_set(mesh, "A")->vertices.size(), 20'000u);
  const auto held = read_text("a.inp", cloud(20'000) + "*BOUNDARY\n" + repeated("all, 1\nall, 2, 3\n", 30'000));
  EXPECT_EQ(held.supports.size(), 2u);
  const auto surface =
      read_text("a.inp", cloud(20'000) + "*SURFACE, NAME=s, TYPE=NODE\n" + repeated("all\nAll\n", 60'000));
  EXPECT_EQ(find_set(surface, "s")->vertices.size(), 20'000u);
}

TEST(ReadInpSets, OutOfProportionToTheFileAreRefused) {
  std::string sets, chain = "*NSET, NSET=s0\nall\n";
  for (int i = 1; i < 3000; ++i) {
    const auto name = "s" + std::to_string(i);
    sets += "*NSET, NSET=" + name + ", GENERATE\n1,20000\n";
    chain += "*NSET, NSET=" + name + "\ns" + std::to_string(i - 1) + "\n";
  }
  for (const auto& more : {sets, chain}) {
    const auto error = error_of("a.inp", cloud(20'000) + more);
    EXPECT_NE(error.find("out of proportion"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace ritz::readers::testing
