// A keyword line that ends in a comma: the next line continues it where it reads as parameters, else it is data.
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

void expect_unchanged(const std::string& text) {
  SCOPED_TRACE(text);
  const auto mesh = read_text("a.inp", text);
  expect_two_tets(mesh, "Lower", "upper", "Bottom");
  EXPECT_EQ(mesh.regions[0].material.young, 2e11);
  EXPECT_EQ(mesh.regions[0].material.density, 7800);
  EXPECT_EQ(mesh.regions[1].material.poisson, 0.49);
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(find_set(mesh, "both")->vertices.size(), 5u);
  ASSERT_EQ(mesh.supports.size(), 2u);
  EXPECT_EQ(mesh.supports[0].held, (std::array{true, true, false}));
  EXPECT_EQ(mesh.supports[1].vertices, (std::vector<Index>{3}));
}

TEST(ReadInpComma, BeforeDataChangesNothing) {
  for (const char* const line : {"*Heading", "*NODE, NSET=Nall", "*ELEMENT, type=CPS3, ELSET=Bottom", "elset=Lower",
                                 "TYPE=C3D4, ELSET=upper", "ELSET=both, GENERATE", "NSET=feet", "NAME=Steel",
                                 "*ELASTIC", "*DENSITY", "TYPE=ISO", "MATERIAL=STEEL", "*STEP", "*BOUNDARY"})
    for (const char* const comma : {",", " ,", ", \t ", ",\n** a comment between\n** and, another = one"})
      expect_unchanged(with(inp_text(), std::string(line) + "\n", std::string(line) + comma + "\n"));
}

TEST(ReadInpComma, BeforeDataChangesNothingWithWindowsLineEnds) {
  expect_unchanged(with_crlf(with(inp_text(), "*BOUNDARY\n", "*BOUNDARY,\n")));
  expect_unchanged(with_crlf(with(inp_text(), "*DENSITY\n", "*DENSITY, \n")));
}

TEST(ReadInpComma, BeforeParametersContinuesTheKeyword) {
  expect_unchanged(with(inp_text(), "*ELSET, ELSET=both, GENERATE\n", "*ELSET, ELSET=both,\nGENERATE\n"));
  expect_unchanged(with(inp_text(), "*ELSET, ELSET=both, GENERATE\n", "*ELSET,\n  Elset = both,\n** so\n generate,\n"));
  expect_unchanged(with(inp_text(), "*NSET, NSET=feet\n", "*NSET,\nNSET=feet,\nUNSORTED,\nINTERNAL\n"));
  expect_unchanged(with(inp_text(), "*BOUNDARY\n", "*BOUNDARY,\nOP=NEW\n"));
  expect_unchanged(with(inp_text(), "*BOUNDARY\n", "*BOUNDARY,\nOP=NEW,\n"));
  expect_unchanged(with(inp_text(), "*SOLID SECTION, ELSET=upper, MATERIAL=Rubber",
                        "*SOLID SECTION, ELSET=upper,\n MATERIAL=Rubber"));
}

TEST(ReadInpComma, ContinuesAnInclude) {
  const TemporaryFile feet("feet.txt", "10, 7\n30\n");
  for (const char* const include : {"*INCLUDE,\n INPUT=feet.txt\n", "*INCLUDE, INPUT=feet.txt,\n"})
    expect_unchanged(with(inp_text(), "10, 7,\n30,\n", include));
}

TEST(ReadInpComma, BeforeAKeywordEndsTheKeyword) {
  expect_unchanged(with(inp_text(), "*STEP\n", "*NSET, NSET=empty,\n*ELSET, ELSET=empty, \n*STEP,\n"));
  expect_unchanged(with(inp_text(), "*MATERIAL, NAME=rubber\n", "*MATERIAL,\nNAME=rubber,\n"));
}

TEST(ReadInpComma, ThatCouldMeanBothIsRefused) {
  const auto mixed = error_of("a.inp", with(inp_text(), "*BOUNDARY\nFeet, 1, 2", "*BOUNDARY,\nOP=NEW, 1, 2"));
  EXPECT_NE(mixed.find("a.inp:38: "), std::string::npos) << mixed;
  EXPECT_NE(mixed.find("parameters and data"), std::string::npos) << mixed;
  const auto named = error_of("a.inp", with(inp_text(), "*MATERIAL, NAME=Steel",
                                            "*NSET, NSET=Internal\n10\n*NSET, NSET=more,\ninternal\n"
                                            "*MATERIAL, NAME=Steel"));
  EXPECT_NE(named.find("a.inp:26: "), std::string::npos) << named;
  EXPECT_NE(named.find("the name of a set"), std::string::npos) << named;
}

TEST(ReadInpComma, InQuotesSeparatesNothing) {
  const auto mesh =
      read_text("a.inp", with(inp_text(), "*NSET, NSET=feet\n10, 7,\n30,\n",
                              "*NSET, NSET=\"left, lower\"\n10\n*NSET, NSET=feet\n\"left, lower\", 7, 30\n"));
  EXPECT_EQ(find_set(mesh, "left, lower")->vertices, (std::vector<Index>{0}));
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2}));
}

}  // namespace
}  // namespace ritz::readers::testing
