// *INCLUDE: files that repeat, and files that are none of ours.
#include <gtest/gtest.h>

#include <memory>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

TEST(Include, OfTheSameFileInTwoPlacesReadsItTwice) {
  const TemporaryFile feet("feet.txt", "10, 7\n30\n");
  const auto mesh = read_text(
      "a.inp",
      with(inp_text(), "10, 7,\n30,\n", "*INCLUDE, INPUT=feet.txt\n*NSET, NSET=others\n*INCLUDE, INPUT=feet.txt\n"));
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(find_set(mesh, "others")->vertices, (std::vector<Index>{0, 1, 2}));
}

TEST(Include, AgainAndAgainIsRefused) {
  const TemporaryFile leaf("leaf.txt", std::string(1 << 20, '*') + "\n");
  std::string lines;
  for (int i = 0; i < 1100; ++i) lines += "*INCLUDE, INPUT=leaf.txt\n";
  EXPECT_NE(error_of("a.inp", lines).find("out of proportion"), std::string::npos);
  const TemporaryFile empty("leaf.txt", "**\n");
  EXPECT_NE(error_of("a.inp", lines).find("a.inp:1001: more than 1000"), std::string::npos);
}

TEST(Include, DoublingAtEveryLevelIsRefused) {
  std::vector<std::unique_ptr<TemporaryFile>> files;
  files.push_back(std::make_unique<TemporaryFile>("l0.txt", "**\n"));
  for (int i = 1; i < 40; ++i) {
    const auto line = "*INCLUDE, INPUT=l" + std::to_string(i - 1) + ".txt\n";
    files.push_back(std::make_unique<TemporaryFile>("l" + std::to_string(i) + ".txt", line + line));
  }
  EXPECT_NE(error_of("a.inp", "*INCLUDE, INPUT=l39.txt\n").find("more than 1000"), std::string::npos);
}

TEST(Include, OfAForeignFileShowsNothingOfIt) {
  const std::string secret = "hunter2";
  for (const char* const content : {"hunter2:x:0:0\n", "*/5 * * * * hunter2 -p\n", "* hunter2\n", "1, 2, hunter2\n",
                                    "hunter2, 1\n", "hunter2, S1\n"}) {
    const TemporaryFile foreign("foreign", content);
    for (const char* const keyword : {"*NODE", "*ELEMENT, TYPE=C3D4", "*NSET, NSET=n", "*ELSET, ELSET=e, GENERATE",
                                      "*BOUNDARY", "*SURFACE, NAME=s", "*SURFACE, NAME=s, TYPE=NODE"}) {
      SCOPED_TRACE(std::string(keyword) + " " + content);
      const auto error =
          error_of("a.inp", with(inp_text(), "*STEP\n", std::string(keyword) + "\n*INCLUDE, INPUT=foreign\n*STEP\n"));
      EXPECT_EQ(error.find(secret), std::string::npos) << error;
      EXPECT_NE(error.find("foreign:1: "), std::string::npos) << error;
    }
    const auto veg = error_of("a.veg", "*VERTICES\n5 3 0 0\n*INCLUDE foreign\n" + veg_text());
    EXPECT_EQ(veg.find(secret), std::string::npos) << veg;
  }
}

TEST(Include, StillNamesWhatToSay) {
  const TemporaryFile part("part.txt", "*TIE, NAME=t\na, b\n");
  const auto error = error_of("a.inp", with(inp_text(), "*STEP\n", "*INCLUDE, INPUT=part.txt\n*STEP\n"));
  EXPECT_NE(error.find("part.txt:1: *TIE"), std::string::npos) << error;
  EXPECT_NE(error.find("'-ignore TIE'"), std::string::npos) << error;
}

}  // namespace
}  // namespace ritz::readers::testing
