// *NODE and *ELEMENT: coordinates that are left blank, normals, and the names of element types.
#include <gtest/gtest.h>

#include <algorithm>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

TEST(ReadInpNodes, TakeBlankCoordinatesAsZero) {
  auto text = with(inp_text(), "10, 0, 0, 0\n", "10, , ,\n");
  text = with(text, "7, 1., 0, 0\n", "7, 1.\n");
  text = with(text, "4000, 0, 0, 1\n", "4000,,, 1\n");
  expect_two_tets(read_text("a.inp", text), "Lower", "upper", "Bottom");
}

TEST(ReadInpNodes, ReadPastNormals) {
  auto text = with(inp_text(), "7, 1., 0, 0\n", "7, 1., 0, 0, 0., 0., 1.\n");
  text = with(text, "4000, 0, 0, 1\n", "4000, , , 1, 1., ,\n");
  expect_two_tets(read_text("a.inp", text), "Lower", "upper", "Bottom");
  EXPECT_NE(error_of("a.inp", with(inp_text(), "7, 1., 0, 0\n", "7, 1., 0, 0, nan\n")).find(":5: "), std::string::npos);
}

TEST(ReadInpNodes, MayBeSeparatedByBlanks) {
  expect_two_tets(read_text("a.inp", with(inp_text(), "50, 1, 1, 1\n", "50 1 1 1\n")), "Lower", "upper", "Bottom");
}

TEST(ReadInpNodes, ReadFromAFileOfTheirOwnAreRefused) {
  EXPECT_NE(error_of("a.inp", with(inp_text(), "*NODE, NSET=Nall", "*NODE, INPUT=n.txt")).find("*INCLUDE"),
            std::string::npos);
}

TEST(ReadInpElements, OfOtherFormulationsOfTheSameTetrahedronAreRead) {
  for (const char* const type : {"C3D4H", "c3d4ht"}) {
    SCOPED_TRACE(type);
    const auto mesh = read_text("a.inp", with(inp_text(), "TYPE=c3d4", "TYPE=" + std::string(type)));
    expect_two_tets(mesh, "Lower", "upper", "Bottom");
    ASSERT_EQ(mesh.notes.size(), 1u);
    EXPECT_NE(mesh.notes[0].find("a.inp:12: element type C3D4H"), std::string::npos) << mesh.notes[0];
    EXPECT_NE(mesh.notes[0].find("hybrid"), std::string::npos) << mesh.notes[0];
  }
  const auto same = read_text("a.inp", with(inp_text(), "TYPE=c3d4", "TYPE=C3D4T"));
  expect_two_tets(same, "Lower", "upper", "Bottom");
  EXPECT_TRUE(same.notes.empty());
}

std::string one_tet10(const std::string& type) {
  return "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, .5, 0, 0\n6, .5, .5, 0\n7, 0, .5, 0\n8, 0, 0, .5\n"
         "9, .5, 0, .5\n10, 0, .5, .5\n*ELEMENT, TYPE=" +
         type + "\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n";
}

TEST(ReadInpElements, OfTenVerticesAreOneElement) {
  const auto plain = read_text("a.inp", one_tet10("C3D10"));
  for (const auto& [type, notes] :
       {std::pair{"C3D10T", 0u}, {"C3D10M", 1u}, {"C3D10H", 1u}, {"C3D10MH", 1u}, {"C3D10MT", 1u}, {"C3D10HS", 1u}}) {
    SCOPED_TRACE(type);
    const auto mesh = read_text("a.inp", one_tet10(type));
    EXPECT_EQ(mesh.cell_types, plain.cell_types);
    EXPECT_EQ(mesh.cell_vertices, plain.cell_vertices);
    EXPECT_EQ(mesh.notes.size(), notes);
  }
}

std::string one_hex(const std::string& type) {
  return "*NODE\n1\n2, 1\n3, 1, 1\n4, 0, 1\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=" + type +
         "\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
}

TEST(ReadInpElements, OfEightVerticesAreReadOnlyWhereTheyAreTheSame) {
  const auto plain = read_text("a.inp", one_hex("C3D8"));
  EXPECT_EQ(read_text("a.inp", one_hex("C3D8T")).cell_vertices, plain.cell_vertices);
  for (const std::string type : {"C3D8R", "C3D8I", "C3D8H", "C3D8RH", "C3D8RT"}) {
    SCOPED_TRACE(type);
    const auto error = error_of("a.inp", one_hex(type));
    EXPECT_NE(error.find("a.inp:10: element type " + type), std::string::npos) << error;
    EXPECT_NE(error.find("2 x 2 x 2"), std::string::npos) << error;
    EXPECT_NE(error.find("'-ignore " + type + "' reads it as C3D8"), std::string::npos) << error;
    const auto mesh = read_text("a.inp", one_hex(type), {type});
    EXPECT_EQ(mesh.cell_vertices, plain.cell_vertices);
    ASSERT_EQ(mesh.notes.size(), 1u);
    EXPECT_NE(mesh.notes[0].find("it is read as C3D8 (-ignore " + type + ")"), std::string::npos) << mesh.notes[0];
  }
}

TEST(ReadInpElements, OfUnreadTypesAreLeftOutOnTheUsersWord) {
  const auto text = with(inp_text(), "*ELSET, ELSET=both",
                         "*ELEMENT, TYPE=C3D27, ELSET=bricks\n9, 1, 2, 3, 4, 5, 6\n*ELSET, ELSET=both");
  EXPECT_NE(error_of("a.inp", text).find("-ignore C3D27"), std::string::npos);
  const auto mesh = read_text("a.inp", text, {"C3D27"});
  expect_two_tets(mesh, "Lower", "upper", "Bottom");
  EXPECT_EQ(mesh.notes.size(), 1u);
}

TEST(DegenerateCells, OfLowerDimensionCarryTheirSets) {
  const auto line = with(with(msh22_text(), "$Elements\n4", "$Elements\n5"), "2 2 2 7 1 10 30 7\n",
                         "2 2 2 7 1 10 30 7\n3 1 2 8 1 50 50\n");
  expect_two_tets(read_text("a.msh", line), "lower", "the upper one", "bottom");
  EXPECT_EQ(find_set(read_text("a.msh", line), "8")->vertices, (std::vector<Index>{4}));
  const auto triangle = read_text("a.inp", with(inp_text(), "2, 10, 30, 7\n", "2, 10, 30, 7\n3, 10, 7, 7\n"));
  EXPECT_EQ(find_set(triangle, "Bottom")->faces.size(), 1u);  // one without area is no face
  EXPECT_EQ(find_set(triangle, "Bottom")->vertices, (std::vector<Index>{0, 1, 2}));
}

TEST(DegenerateCells, OfFourVerticesAreTheTriangleOfThree) {
  for (const char* const quad : {"2, 10, 10, 30, 7", "2, 10, 30, 7, 7", "2, 7, 10, 30, 7"}) {
    SCOPED_TRACE(quad);
    const auto mesh = read_text("a.inp", with(with(inp_text(), "type=CPS3", "type=S4"), "2, 10, 30, 7", quad));
    const auto& faces = find_set(mesh, "Bottom")->faces;
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].type, fem::FaceType::tri3);
    std::vector<Index> around(faces[0].vertices.begin(), faces[0].vertices.begin() + 3);
    std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
    EXPECT_EQ(around, (std::vector<Index>{0, 2, 1}));
  }
}

}  // namespace
}  // namespace ritz::readers::testing
