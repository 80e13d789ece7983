// *PART, *ASSEMBLY and *INSTANCE: where the nodes are, how they are numbered, and what names mean.
#include <gmock/gmock.h>

#include <cmath>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string tetra_part =
    "*PART, NAME=Tetra\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n5, 0, 0, 1\n"
    "*ELEMENT, TYPE=C3D4, ELSET=E\n7, 1, 2, 3, 5\n*NSET, NSET=foot\n1, 2\n*NSET, NSET=more\nfoot, 3\n"
    "*ELSET, ELSET=cells\n7\n*SURFACE, NAME=base\nE, S1\n*SOLID SECTION, ELSET=E, MATERIAL=steel\n,\n*END PART\n";

const std::string material = "*MATERIAL, NAME=steel\n*ELASTIC\n2e11, .3\n*DENSITY\n7800\n";

/// A deck of the part, with the assembly and the steps.
std::string assembled(const std::string& assembly, const std::string& steps = "") {
  return tetra_part + "*ASSEMBLY, NAME=A\n" + assembly + "*END ASSEMBLY\n" + material + steps;
}

std::string instance_of(const std::string& name, const std::string& placement = "") {
  return "*INSTANCE, NAME=" + name + ", PART=tetra\n" + placement + "*END INSTANCE\n";
}

const std::string two = instance_of("I-1", "1., 0., 0.\n0,0,0, 0,0,1, 90.\n") + instance_of("I-2", "0, 0, 5\n");

TEST(InpInstances, AreTranslatedThenRotated) {
  const auto mesh = read_text("a.inp", assembled(two));
  using P = std::array<double, 3>;
  EXPECT_THAT(mesh.points, ElementsAre(P{0, 1, 0}, P{0, 2, 0}, P{-1, 1, 0}, P{0, 1, 1},  //
                                       P{0, 0, 5}, P{1, 0, 5}, P{0, 1, 5}, P{0, 0, 6}));
  EXPECT_THAT(mesh.cell_vertices, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(InpInstances, TurnAboutAnyAxisByAnyAngle) {
  // By 120 degrees about (1, 1, 1) through (1, 0, 0): x, y, z become y, z, x of the arm.
  const auto mesh = read_text("a.inp", assembled(instance_of("I", "0, 0, 0\n1, 0, 0, 2, 1, 1, 120\n")));
  const std::array<double, 3> origin = mesh.points[0], expected = {1, -1, 0};  // its arm is (-1, 0, 0)
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(origin[i], expected[i], 1e-15);
  for (const auto& [angle, x, y] : {std::tuple{-90., 0., -1.}, {180., -1., 0.}, {270., 0., -1.}, {450., 0., 1.}}) {
    const auto turned =
        read_text("a.inp", assembled(instance_of("I", ",,\n0,0,0,0,0,2, " + std::to_string(angle) + "\n"))).points[1];
    EXPECT_THAT(turned, ElementsAre(x, y, 0)) << angle;
  }
}

TEST(InpInstances, HaveNumbersAboveThoseBefore) {
  const auto mesh = read_text("a.inp", assembled(two));
  EXPECT_THAT(mesh.vertex_ids, ElementsAre(1, 2, 3, 5, 6, 7, 8, 10));
  EXPECT_THAT(mesh.cell_ids, ElementsAre(7, 14));
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_THAT(mesh.notes[0], HasSubstr("I-1 + 0, I-2 + 5"));
}

TEST(InpInstances, OfOneKeepTheNumbersOfThePart) {
  const auto mesh = read_text("a.inp", assembled(instance_of("only")));
  EXPECT_THAT(mesh.vertex_ids, ElementsAre(1, 2, 3, 5));
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(InpInstances, GiveTheirNameToTheirSets) {
  const auto mesh = read_text("a.inp", assembled(two));
  for (const auto* name : {"I-1", "I-2"}) {
    const Index first = name == std::string("I-1") ? 0 : 4;
    const auto set = [&](const std::string& own) { return find_set(mesh, name + std::string(".") + own); };
    ASSERT_TRUE(set("foot") && set("more") && set("all") && set("base") && set("cells")) << name;
    EXPECT_THAT(set("foot")->vertices, ElementsAre(first, first + 1));
    EXPECT_THAT(set("more")->vertices, ElementsAre(first, first + 1, first + 2));
    EXPECT_THAT(set("base")->vertices, ElementsAre(first, first + 1, first + 2));
    EXPECT_EQ(set("base")->faces.size(), 1u);
    EXPECT_EQ(set("cells")->vertices.size(), 4u);
  }
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"I-1.E", "I-2.E"}));
  for (const auto& region : mesh.regions) EXPECT_EQ(region.material.young, 2e11);
}

TEST(InpInstances, AreNamedByTheSetsOfTheAssembly) {
  const auto mesh = read_text(
      "a.inp",
      assembled(
          two +
          "*NSET, NSET=tips, INSTANCE=I-2\n5,\n*NSET, NSET=tips, INSTANCE=I-1\n5,\n"
          "*NSET, NSET=feet, INSTANCE=i-2\nfoot\n*NSET, NSET=both\nfeet, I-1.foot\n"
          "*NSET, NSET=few, INSTANCE=I-2, GENERATE\n1, 3\n*ELSET, ELSET=_s, INTERNAL, INSTANCE=I-2\n7\n"
          "*SURFACE, TYPE=ELEMENT, NAME=under\n_s, S1\nI-1.7, S1\n*SURFACE, TYPE=NODE, NAME=dots\nI-2.5\nfeet\n"));
  EXPECT_THAT(find_set(mesh, "tips")->vertices, ElementsAre(3, 7));
  EXPECT_THAT(find_set(mesh, "feet")->vertices, ElementsAre(4, 5));
  EXPECT_THAT(find_set(mesh, "both")->vertices, ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(find_set(mesh, "few")->vertices, ElementsAre(4, 5, 6));
  EXPECT_THAT(find_set(mesh, "under")->vertices, ElementsAre(0, 1, 2, 4, 5, 6));
  EXPECT_EQ(find_set(mesh, "under")->faces.size(), 2u);
  EXPECT_THAT(find_set(mesh, "dots")->vertices, ElementsAre(4, 5, 7));
}

TEST(InpInstances, AreHeldByStepsThatNameThem) {
  const auto mesh =
      read_text("a.inp", assembled(two, "*STEP\n*BOUNDARY\nI-1.foot, ENCASTRE\nI-2.5, 1, 2\n*END STEP\n"));
  ASSERT_EQ(mesh.supports.size(), 2u);
  EXPECT_THAT(mesh.supports[0].vertices, ElementsAre(0, 1));
  EXPECT_THAT(mesh.supports[1].vertices, ElementsAre(7));
}

TEST(InpInstances, MayBringTheirOwnMesh) {
  std::string text =
      assembled("*INSTANCE, NAME=I, PART=tetra\n0, 0, 2\n" +
                tetra_part.substr(tetra_part.find("*NODE"), tetra_part.find("*END PART") - tetra_part.find("*NODE")) +
                "*END INSTANCE\n");
  const auto begin = text.find("*NODE"), end = text.find("*END PART");
  text.erase(begin, end - begin);
  const auto mesh = read_text("a.inp", text);
  EXPECT_EQ(mesh.points[3], (std::array<double, 3>{0, 0, 3}));
  EXPECT_TRUE(find_set(mesh, "I.foot"));
}

TEST(InpInstances, LeaveNodesOfTheAssemblyTheirNumbers) {
  const auto mesh = read_text("a.inp", assembled(two + "*NODE\n1, 9, 9, 9\n*NSET, NSET=point\n1\n"));
  EXPECT_EQ(mesh.points.back(), (std::array<double, 3>{9, 9, 9}));
  EXPECT_THAT(find_set(mesh, "point")->vertices, ElementsAre(8));
}

TEST(InpInstances, SayWhatIsWrong) {
  const struct {
    std::string text, line, words;
  } cases[] = {
      {tetra_part.substr(0, tetra_part.find("*END PART")), ":1", "*END PART"},
      {tetra_part + tetra_part, ":20", "twice"},
      {"*PART, NAME=a\n" + tetra_part, ":2", "inside a part"},
      {"*PART\n*END PART\n", ":1", "needs NAME="},
      {"*END PART\n", ":1", "ends nothing"},
      {tetra_part + "*ASSEMBLY\n" + two, ":20", "*END ASSEMBLY"},
      {tetra_part + "*ASSEMBLY\n*INSTANCE, NAME=I, PART=tetra\n", ":21", "*END INSTANCE"},
      {assembled("*INSTANCE, NAME=I, PART=tetra\n"), ":22", "ends nothing"},
      {assembled("*INSTANCE, NAME=I, PART=nut\n*END INSTANCE\n"), ":21", "'nut'"},
      {assembled("*INSTANCE, NAME=I\n*END INSTANCE\n"), ":21", "needs PART="},
      {assembled(instance_of("I") + instance_of("i")), ":23", "twice"},
      {assembled("*INSTANCE, NAME=I, PART=tetra\n*INSTANCE, NAME=J, PART=tetra\n"), ":22", "inside an instance"},
      {assembled("*INSTANCE, NAME=I, LIBRARY=old\n"), ":21", "LIBRARY"},
      {assembled(instance_of("I", "1, 2, x\n")), ":22", "'x'"},
      {assembled(instance_of("I", "1, 2, 3, 4\n")), ":22", "3 numbers"},
      {assembled(instance_of("I", "0, 0, 0\n1, 1, 1, 1, 1, 1, 90\n")), ":23", "the same"},
      {assembled(instance_of("I", "0, 0, 0\n0, 0, 0, 0, 0, 1, 90\n3\n")), ":24", "two data lines"},
      {assembled(two + "*NSET, NSET=a, INSTANCE=J\n1\n"), ":28", "'J'"},
      {assembled(two + "*NSET, NSET=a, INSTANCE=I-1\nhead\n"), ":29", "'head'"},
      {assembled(two, "*BOUNDARY\nI-1.head, 1\n"), ":35", "I-1.head"},
      {assembled(instance_of("I") + "*NODE\n1, 0, 0, 0\n" + instance_of("J")), ":25", "outside of instances"},
  };
  for (const auto& [text, line, words] : cases) {
    const auto error = error_of("a.inp", text);
    EXPECT_THAT(error, HasSubstr("a.inp" + line + ":")) << text;
    EXPECT_THAT(error, HasSubstr(words)) << text;
  }
}

TEST(InpInstances, InProportionToTheFile) {
  std::string text = "*PART, NAME=tetra\n*NODE\n";
  for (int i = 0; i < 40000; ++i) text += std::to_string(i) + ",1\n";
  text += "*END PART\n*ASSEMBLY\n";
  for (int i = 0; i < 400; ++i) text += instance_of("I" + std::to_string(i));
  EXPECT_THAT(error_of("a.inp", text + "*END ASSEMBLY\n"), HasSubstr("proportion"));
}

}  // namespace
}  // namespace ritz::readers::testing
