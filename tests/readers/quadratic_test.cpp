// The order of vertices in cells with mid-edge vertices and in hexahedra, from files as Gmsh writes them.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using Point = std::array<double, 3>;

Point middle(const Point& a, const Point& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }

double determinant(const Point& o, const Point& a, const Point& b, const Point& c) {
  const auto d = [&](const Point& p, int i) { return p[static_cast<std::size_t>(i)] - o[static_cast<std::size_t>(i)]; };
  return d(a, 0) * (d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1)) - d(a, 1) * (d(b, 0) * d(c, 2) - d(b, 2) * d(c, 0)) +
         d(a, 2) * (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0));
}

Point point(const FileMesh& mesh, std::size_t c, std::size_t i) {
  const auto at = static_cast<std::size_t>(mesh.cell_offsets[c]) + i;
  return mesh.points[static_cast<std::size_t>(mesh.cell_vertices[at])];
}

void expect_middles(const FileMesh& mesh) {
  constexpr std::size_t edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (std::size_t c = 0; c < mesh.cell_types.size(); ++c) {
    EXPECT_GT(determinant(point(mesh, c, 0), point(mesh, c, 1), point(mesh, c, 2), point(mesh, c, 3)), 0);
    for (std::size_t e = 0; e < 6; ++e) {
      EXPECT_EQ(point(mesh, c, 4 + e), middle(point(mesh, c, edges[e][0]), point(mesh, c, edges[e][1])))
          << "edge " << e;
    }
  }
}

void expect_face_middles(const FileMesh& mesh, const NamedSet* set) {
  ASSERT_TRUE(set);
  ASSERT_EQ(set->faces.size(), 1u);
  ASSERT_EQ(set->faces[0].type, fem::FaceType::tri6);
  EXPECT_EQ(set->vertices.size(), 6u);
  const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(set->faces[0].vertices[i])]; };
  for (std::size_t e = 0; e < 3; ++e) EXPECT_EQ(at(3 + e), middle(at(e), at((e + 1) % 3)));
}

// Points of a Tet10 in Gmsh's own order: middles of 01, 12, 20, 03, 23, 13.
constexpr const char* tet10_points[] = {"0 0 0", "2 0 0", "0 2 0", "0 0 2", "1 0 0",
                                        "1 1 0", "0 1 0", "0 0 1", "0 1 1", "1 0 1"};

std::string tet10_msh() {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n";
  for (int v = 0; v < 10; ++v) text += std::to_string(v + 1) + " " + tet10_points[v] + "\n";
  return text + "$EndNodes\n$Elements\n2\n1 9 2 5 1 1 3 2 7 6 5\n2 11 2 1 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n";
}

std::string tet10_inp() {
  std::string text = "*NODE\n";
  for (int v = 0; v < 10; ++v) {
    std::string point = tet10_points[v];
    for (char& c : point) c = c == ' ' ? ',' : c;
    text += std::to_string(v + 1) + ", " + point + "\n";
  }
  // Abaqus: ... 14, 24, 34 as vertices 8, 9, 10.
  return text + "*ELEMENT, TYPE=C3D10, ELSET=body\n1, 1, 2, 3, 4, 5, 6, 7, 8, 10, 9\n*SURFACE, NAME=5\nbody, S1\n";
}

TEST(Tet10, OfGmshIsPutIntoOurOrder) {
  const auto mesh = read_text("a.msh", tet10_msh());
  expect_consistent(mesh);
  expect_middles(mesh);
  expect_face_middles(mesh, find_set(mesh, "5"));
}

TEST(Tet10, OfAbaqusIsInOurOrder) {
  const auto mesh = read_text("a.inp", tet10_inp());
  expect_consistent(mesh);
  expect_middles(mesh);
  expect_face_middles(mesh, find_set(mesh, "5"));
  EXPECT_EQ(mesh.cell_vertices, read_text("a.msh", tet10_msh()).cell_vertices);
}

TEST(Tet10, OfVtkIsInOurOrder) {
  std::string text =
      "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"10\" NumberOfCells=\"1\"><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\">";
  for (const char* const point : tet10_points) text += std::string(point) + " ";
  text +=
      "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 3 4 5 6 7 9 8</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\">10</DataArray><DataArray type=\"Int16\" Name=\"types\">24"
      "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
  const auto mesh = read_text("a.vtu", text);
  expect_middles(mesh);
  EXPECT_EQ(cell_region_names(mesh), std::vector<std::string>{"default"});
}

constexpr const char* cube = "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n";

void expect_unit_cube(const FileMesh& mesh) {
  expect_consistent(mesh);
  ASSERT_EQ(mesh.cell_types, std::vector{fem::CellType::hex8});
  const auto corner = [&](std::size_t i) { return point(mesh, 0, i); };
  EXPECT_EQ(determinant(corner(0), corner(1), corner(3), corner(4)), 1);
  EXPECT_EQ(corner(2), (Point{1, 1, 0}));
  EXPECT_EQ(corner(6), (Point{1, 1, 1}));
}

TEST(Hex8, IsTheSameInEveryFormat) {
  const std::string points = cube;
  expect_unit_cube(
      read_text("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n" + points +
                             "$EndNodes\n$Elements\n2\n1 3 2 1 1 1 4 3 2\n2 5 0 1 2 3 4 5 6 7 8\n$EndElements\n"));
  expect_unit_cube(read_text("a.veg", "*VERTICES\n8 3\n" + points + "*ELEMENTS\nCUBIC\n1 8 0\n1 1 2 3 4 5 6 7 8\n"));
  std::string commas = points;
  for (char& c : commas) c = c == ' ' ? ',' : c;
  const auto mesh = read_text("a.inp", "*NODE\n" + commas +
                                           "*ELEMENT, TYPE=C3D8, ELSET=c\n1,1,2,3,4,5,6,7,8\n"
                                           "*SURFACE, NAME=s\nc, S1\nc, S2\nc, S3\nc, S4\nc, S5\nc, S6\n");
  expect_unit_cube(mesh);
  // Abaqus: 1-2-3-4, 5-8-7-6, 1-5-6-2, 2-6-7-3, 3-7-8-4, 4-8-5-1.
  constexpr int sums[] = {10 - 4, 26 - 4, 14 - 4, 18 - 4, 22 - 4, 18 - 4};
  const auto& faces = find_set(mesh, "s")->faces;
  ASSERT_EQ(faces.size(), 6u);
  for (std::size_t f = 0; f < 6; ++f) {
    const auto& v = faces[f].vertices;
    EXPECT_EQ(v[0] + v[1] + v[2] + v[3], sums[f]) << "S" << f + 1;
  }
}

}  // namespace
}  // namespace ritz::readers::testing
