// The same mesh in every format, and what is particular to each.
#include <gtest/gtest.h>

#include <set>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

void expect_two_tets_in(const NamedFile& file) {
  SCOPED_TRACE(file.label);
  const auto mesh = read_text(file.name, file.bytes);
  if (file.name == "a.msh") expect_two_tets(mesh, "lower", "the upper one", "bottom");
  if (file.name == "a.veg") expect_two_tets(mesh, "lower", "upper", "");
  if (file.name == "a.inp") expect_two_tets(mesh, "Lower", "upper", "Bottom");
  if (file.name == "a.vtu") expect_two_tets(mesh, "1", "2", "7");
}

bool is_text(const NamedFile& file) {
  return file.label.find("binary") == std::string::npos && file.label.find("form") == std::string::npos;
}

TEST(Readers, GiveTheSameMeshFromEveryFormat) {
  for (const auto& file : good_files()) expect_two_tets_in(file);
}

TEST(Readers, TakeWindowsLineEndsAndMarksAndNoLastNewline) {
  for (auto file : good_files()) {
    if (!is_text(file)) continue;
    const auto bytes = file.bytes;
    file.bytes = with_crlf(bytes);
    expect_two_tets_in(file);
    file.bytes = without_last_newline(bytes);
    expect_two_tets_in(file);
    file.bytes = "\xEF\xBB\xBF" + bytes;
    expect_two_tets_in(file);
  }
}

TEST(Readers, KeepTheFilesOwnNumbers) {
  const std::vector<Index> sparse = {10, 7, 30, 4000, 50};
  for (const auto& file : good_files()) {
    const auto mesh = read_text(file.name, file.bytes);
    if (file.name == "a.veg") {
      EXPECT_EQ(mesh.vertex_ids, (std::vector<Index>{1, 2, 3, 4, 5}));
      EXPECT_EQ(mesh.cell_ids, (std::vector<Index>{1, 2}));
    } else if (file.name == "a.vtu") {
      EXPECT_EQ(mesh.vertex_ids, (std::vector<Index>{0, 1, 2, 3, 4}));
      EXPECT_EQ(mesh.cell_ids, (std::vector<Index>{1, 2}));
    } else {
      EXPECT_EQ(mesh.vertex_ids, sparse) << file.label;
      EXPECT_EQ(mesh.cell_ids, (std::vector<Index>{5, 6})) << file.label;
    }
  }
}

TEST(Readers, TakeTheEndingInCapitals) {
  expect_two_tets(read_text("A.MSH", msh22_text()), "lower", "the upper one", "bottom");
}

TEST(ReadMsh, AllowsSeveralPhysicalGroupsOfACell) {
  const auto v41 = read_text("a.msh", msh41_text());
  ASSERT_TRUE(find_set(v41, "9"));  // a group without a name
  EXPECT_EQ(find_set(v41, "9")->vertices, (std::vector<Index>{1, 2, 3, 4}));
  // Version 2.2 repeats the cell with a new number.
  auto text = with(msh22_text(), "6 4 3 2 2 0 7 30 4000 50\n", "6 4 2 2 2 7 30 4000 50\n7 4 2 9 2 7 30 4000 50\n");
  text = with(text, "$Elements\n4", "$Elements\n5");
  const auto v22 = read_text("a.msh", text);
  expect_two_tets(v22, "lower", "the upper one", "bottom");
  ASSERT_TRUE(find_set(v22, "9"));
  EXPECT_EQ(find_set(v22, "9")->vertices, (std::vector<Index>{1, 2, 3, 4}));
}

TEST(ReadMsh, PutsCellsWithoutAGroupIntoADefaultRegion) {
  const auto mesh = read_text("a.msh", with(msh22_text(), "5 4 2 1 1", "5 4 2 0 1"));
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"default", "the upper one"}));
}

TEST(ReadMsh, ReadsParametricNodesOfVersion22) {
  auto text = with(msh22_text(), "$Nodes\n5\n10 0 0 0\n7 1 0 0\n30 0 1.0 0\n4000 0 0 1e0\n50 +1 1 1\n$EndNodes",
                   "$ParametricNodes\n5\n10 0 0 0 0 1\n7 1 0 0 1 1 0.5\n30 0 1 0 2 1 0.5 0.75\n4000 0 0 1 3 1\n"
                   "50 1 1 1 3 1\n$EndParametricNodes");
  expect_two_tets(read_text("a.msh", text), "lower", "the upper one", "bottom");
}

TEST(ReadMsh, ReadsGroupsOfAPartitionedMesh) {
  auto text = with(msh41_text(), "$Nodes\n",
                   "$PartitionedEntities\n2\n1\n9 1\n0 0 0 1\n"
                   "5 3 1 2 1 2 0 0 0 1 1 1 1 1 1 -1\n$EndPartitionedEntities\n$Nodes\n");
  text = with(text, "3 1 4 1\n5 10", "3 5 4 1\n5 10");
  expect_two_tets(read_text("a.msh", text), "lower", "the upper one", "bottom");
}

TEST(ReadVeg, ReadsMaterialsAndNumbersFromZero) {
  const auto one = read_text("a.veg", veg_text());
  EXPECT_EQ(one.regions[0].material.young, 2e11);
  EXPECT_EQ(one.regions[0].material.poisson, 0.3);
  EXPECT_EQ(one.regions[0].material.density, 7800);
  EXPECT_EQ(one.regions[1].material.young, 1e6);
  const auto zero = read_text("a.veg", R"(*VERTICES
5 3 0 0
0 0 0 0
1 1 0 0
2 0 1 0
3 0 0 1
4 1 1 1
*ELEMENTS
TET
2 4 0
0 0 1 2 3
1 1 2 3 4
*SET lower
0
*SET upper
1
*MATERIAL m
ENU, 1, 1, 0
*REGION
lower, m
*REGION
upper, m
)");
  expect_two_tets(zero, "lower", "upper", "");
  EXPECT_EQ(zero.vertex_ids.front(), 0);
}

TEST(ReadVeg, LetsTheLaterRegionWin) {
  const auto text =
      with(veg_text(), "*REGION\nlower, steel\n", "*REGION\nallElements, rubber\n*REGION\nlower, steel\n");
  const auto mesh = read_text("a.veg", text);
  EXPECT_EQ(cell_region_names(mesh), (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(find_set(mesh, "allElements")->vertices.size(), 5u);
}

TEST(ReadVeg, FollowsIncludes) {
  const auto text = veg_text();
  const auto begin = text.find("5 3 0 0");
  const auto end = text.find("*ELEMENTS");
  const TemporaryFile part("part.veg", text.substr(begin, end - begin));
  auto rest = text;
  rest.replace(begin, end - begin, "*INCLUDE part.veg\n");
  expect_two_tets(read_text("a.veg", rest), "lower", "upper", "");
}

TEST(ReadBou, ReadsNumbersHoweverTheyAreSeparated) {
  const TemporaryFile file("a.bou", "5,1, 3\r\n 2,2,\n");
  EXPECT_EQ(read_bou(file.path(), 5), (std::vector<Index>{0, 1, 2, 4}));
}

TEST(ReadInp, ReadsMaterialsSetsAndSupports) {
  const auto mesh = read_text("a.inp", inp_text());
  EXPECT_EQ(mesh.regions[0].material.young, 2e11);
  EXPECT_EQ(mesh.regions[0].material.density, 7800);
  EXPECT_EQ(mesh.regions[1].material.poisson, 0.49);
  EXPECT_EQ(find_set(mesh, "Nall")->vertices.size(), 5u);
  EXPECT_EQ(find_set(mesh, "both")->vertices.size(), 5u);
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2}));
  ASSERT_EQ(mesh.supports.size(), 2u);
  EXPECT_EQ(mesh.supports[0].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.supports[0].held, (std::array{true, true, false}));
  EXPECT_EQ(mesh.supports[1].vertices, (std::vector<Index>{3}));
  EXPECT_EQ(mesh.supports[1].held, (std::array{false, false, true}));
}

TEST(ReadInp, UnitesSetsOfOneNameAndKind) {
  const auto mesh =
      read_text("a.inp", inp_with("*ELSET, ELSET=pair\n6\n*ELSET, ELSET=PAIR\n2\n*ELSET, ELSET=nested\nlower\n2\n"
                                  "*NSET, NSET=of_cells, ELSET=Lower\n*NSET, NSET=twice\nfeet, 50, twice\n"));
  EXPECT_EQ(find_set(mesh, "pair")->vertices, (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(find_set(mesh, "nested")->vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(find_set(mesh, "nested")->faces.size(), 1u);
  EXPECT_EQ(find_set(mesh, "of_cells")->vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(find_set(mesh, "twice")->vertices, (std::vector<Index>{0, 1, 2, 4}));
}

TEST(ReadInp, TakesOnlyTheExistingNumbersOfARange) {
  const auto mesh = read_text("a.inp", inp_with("*NSET, NSET=some, GENERATE\n1, 1000000000000, 3\n"));
  EXPECT_EQ(find_set(mesh, "some")->vertices, (std::vector<Index>{0, 1, 3}));  // 10, 7 and 4000
}

TEST(ReadInp, KnowsTheFacesOfASurface) {
  const auto mesh =
      read_text("a.inp", inp_with("*SURFACE, NAME=skin, TYPE=ELEMENT\nlower, S1\n5, s2\n6, S3\nBottom, SPOS\n"
                                  "*SURFACE, NAME=dots, TYPE=NODE\nfeet\n50,\n"));
  const auto& skin = *find_set(mesh, "skin");
  // Abaqus: S1 = 1-2-3, S2 = 1-4-2, S3 = 2-4-3. The face of Bottom is lower's S1, and stands once.
  ASSERT_EQ(skin.faces.size(), 3u);
  const auto corners = [&](std::size_t f) {
    return std::set<Index>(skin.faces[f].vertices.begin(), skin.faces[f].vertices.begin() + 3);
  };
  EXPECT_EQ(corners(0), (std::set<Index>{0, 2, 1}));
  EXPECT_EQ(corners(1), (std::set<Index>{0, 1, 3}));
  EXPECT_EQ(corners(2), (std::set<Index>{2, 3, 4}));
  EXPECT_EQ(find_set(mesh, "dots")->vertices, (std::vector<Index>{0, 1, 2, 4}));
  EXPECT_TRUE(find_set(mesh, "dots")->faces.empty());
}

TEST(ReadInp, ReadsNamedConditionsAndIgnoresRotations) {
  const auto mesh =
      read_text("a.inp", inp_with("*BOUNDARY\nfeet, ENCASTRE\nNall, XSYMM\n50, 1, 6, 0.\n50, 5\n50,3,,0\n"));
  ASSERT_EQ(mesh.supports.size(), 7u);
  EXPECT_EQ(mesh.supports[0].held, (std::array{true, true, true}));
  EXPECT_EQ(mesh.supports[1].held, (std::array{true, false, false}));
  EXPECT_EQ(mesh.supports[2].held, (std::array{true, true, true}));
  EXPECT_EQ(mesh.supports[3].held, (std::array{false, false, false}));
  EXPECT_EQ(mesh.supports[4].held, (std::array{false, false, true}));
}

TEST(ReadInp, FixesTheNodesOfAnElementSet) {
  const auto mesh = read_text("a.inp", inp_with("*BOUNDARY\nupper, 2\n"));
  EXPECT_EQ(mesh.supports[0].vertices, (std::vector<Index>{1, 2, 3, 4}));
  EXPECT_EQ(mesh.supports[0].held, (std::array{false, true, false}));
}

TEST(ReadInp, MakesRegionsOfElementSetsWithoutSections) {
  auto text = with(inp_text(), "*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL\n", "*HEADING\n");
  text = with(text, "*SOLID SECTION, ELSET=upper, MATERIAL=Rubber\n", "");
  EXPECT_EQ(cell_region_names(read_text("a.inp", text)), (std::vector<std::string>{"both", "both"}));
  text = with(text, "*ELSET, ELSET=both, GENERATE\n5, 6\n", "");
  EXPECT_EQ(cell_region_names(read_text("a.inp", text)), (std::vector<std::string>{"Lower", "upper"}));
}

TEST(ReadInp, KeepsWhatAnIncompleteMaterialStates) {
  const auto mesh = read_text("a.inp", with(inp_text(), "*DENSITY\n7800.,\n", ""));
  EXPECT_EQ(mesh.regions[0].material.young, 2e11);
  EXPECT_EQ(mesh.regions[0].material.poisson, 0.3);
  EXPECT_FALSE(mesh.regions[0].material.density);
  const auto other = read_text("a.inp", with(inp_text(), "*ELASTIC, TYPE=ISO\n1e6, 0.49\n", ""));
  EXPECT_FALSE(other.regions[1].material.young);
  EXPECT_EQ(other.regions[1].material.density, 950);
}

TEST(ReadInp, FollowsIncludes) {
  const TemporaryFile nodes("nodes.txt", "10, 0, 0, 0\n7, 1, 0, 0\n30, 0, 1, 0");
  const auto text = with(inp_text(), "10, 0, 0, 0\n7, 1., 0, 0\n30, 0, 1.0D+00, 0\n", "*INCLUDE, INPUT=nodes.txt\n");
  expect_two_tets(read_text("a.inp", text), "Lower", "upper", "Bottom");
}

TEST(ReadInp, GrowsNoSetsOfSetsWithoutBound) {
  std::string sets = "*ELSET, ELSET=s0\nlower, upper\n";
  for (int i = 1; i < 60; ++i) {
    const auto last = "s" + std::to_string(i - 1);
    sets += "*ELSET, ELSET=s" + std::to_string(i) + "\n" + last + "," + last + "," + last + "\n";
  }
  EXPECT_EQ(find_set(read_text("a.inp", inp_with(sets)), "s59")->vertices.size(), 5u);
}

TEST(ReadVtu, MakesVertexSetsOfBytes) {
  const auto mesh = read_text("a.vtu", vtu_text());
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_FALSE(find_set(mesh, "heat"));
}

TEST(ReadVtu, PutsPiecesOneAfterTheOther) {
  auto text = vtu_text();
  const auto begin = text.find("<Piece");
  const auto end = text.find("</Piece>") + 8;
  text.insert(end, text.substr(begin, end - begin));
  const auto mesh = read_text("a.vtu", text);
  expect_consistent(mesh);
  EXPECT_EQ(mesh.points.size(), 10u);
  EXPECT_EQ(mesh.cell_types.size(), 4u);
  EXPECT_EQ(mesh.cell_vertices[8], 5);
  EXPECT_EQ(find_set(mesh, "feet")->vertices, (std::vector<Index>{0, 1, 2, 5, 6, 7}));
}

}  // namespace
}  // namespace ritz::readers::testing
