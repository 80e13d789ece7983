// Cells of VTK that are ritz's under another name or in another order, and cells that are none of the body's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::HasSubstr;

// A unit cube whose vertices count along x, then y, then z, with the face z = 0; both cells as `types` says.
std::string vtu_cube(const std::string& types, const std::string& solid, const std::string& face) {
  return R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="2">
<CellData><DataArray type="Int32" Name="region">1 2</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3">
0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity">)" +
         solid + " " + face + R"(</DataArray><DataArray type="Int32" Name="offsets">8 12</DataArray>
<DataArray type="UInt8" Name="types">)" +
         types + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

constexpr const char* counted_solid = "0 1 2 3 4 5 6 7";
constexpr const char* counted_face = "0 1 2 3";
constexpr const char* around_solid = "0 1 3 2 4 5 7 6";
constexpr const char* around_face = "0 1 3 2";

TEST(VtuCells, AreTheSameHexahedronUnderThreeNames) {
  const std::vector<Index> expected = {0, 1, 3, 2, 4, 5, 7, 6};
  for (const auto& text : {vtu_cube("11 8", counted_solid, counted_face), vtu_cube("12 9", around_solid, around_face),
                           vtu_cube("72 70", around_solid, around_face)}) {
    const auto mesh = read_text("a.vtu", text);
    EXPECT_EQ(mesh.cell_types, std::vector(1, fem::CellType::hex8));
    EXPECT_EQ(mesh.cell_vertices, expected);
    ASSERT_EQ(find_set(mesh, "2")->faces.size(), 1u);
    const auto& face = find_set(mesh, "2")->faces[0];
    EXPECT_EQ(std::vector<Index>(face.vertices.begin(), face.vertices.begin() + 4), (std::vector<Index>{0, 1, 3, 2}));
  }
}

TEST(VtuCells, OfLagrangeMayBeTetrahedra) {
  const auto linear = with(vtu_text(), "5 10 10", "69 71 71");
  expect_two_tets(read_text("a.vtu", linear), "1", "2", "7");
}

// One tetrahedron of order 2 with its edge 01 as a set.
std::string tet10(const std::string& types) {
  return R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="10" NumberOfCells="3">
<CellData><DataArray type="Int32" Name="region">1 2 3</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3">
0 0 0 1 0 0 0 1 0 0 0 1 .5 0 0 .5 .5 0 0 .5 0 0 0 .5 .5 0 .5 0 .5 .5</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity">0 1 2 3 4 5 6 7 8 9 0 1 4 0 2 1 6 5 4</DataArray>
<DataArray type="Int32" Name="offsets">10 13 19</DataArray><DataArray type="UInt8" Name="types">)" +
         types + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

TEST(VtuCells, OfLagrangeMayHaveMidEdgeVertices) {
  const auto quadratic = read_text("a.vtu", tet10("24 21 22")), lagrange = read_text("a.vtu", tet10("71 68 69"));
  EXPECT_EQ(lagrange.cell_types, std::vector(1, fem::CellType::tet10));
  EXPECT_EQ(lagrange.cell_vertices, quadratic.cell_vertices);
  EXPECT_EQ(find_set(lagrange, "2")->vertices, (std::vector<Index>{0, 1, 4}));
  EXPECT_EQ(find_set(lagrange, "3")->faces[0].vertices, find_set(quadratic, "3")->faces[0].vertices);
  EXPECT_EQ(find_set(lagrange, "3")->faces[0].type, fem::FaceType::tri6);
}

TEST(VtuCells, ThatAreMarkedAsGhostsAreRefusedUnlessTheyAreIgnored) {
  const auto marked = [](const std::string& name, const std::string& marks) {
    return with(vtu_text(), "<CellData>",
                "<CellData><DataArray type=\"UInt8\" Name=\"" + name + "\">" + marks + "</DataArray>");
  };
  expect_two_tets(read_text("a.vtu", marked("vtkGhostType", "0 0 0")), "1", "2", "7");
  EXPECT_THAT(error_of("a.vtu", marked("vtkGhostType", "0 1 0")), HasSubstr("marks 1 cell as duplicate or hidden"));
  EXPECT_THAT(error_of("a.vtu", marked("vtkGhostLevels", "0 1 1")), HasSubstr("'-ignore VTKGHOSTLEVELS'"));
  const auto mesh = read_text("a.vtu", marked("vtkGhostType", "0 32 0"), {"VTKGHOSTTYPE"});
  expect_two_tets(mesh, "1", "2", "7");
  EXPECT_EQ(mesh.notes.size(), 1u);
}

}  // namespace
}  // namespace ritz::readers::testing
