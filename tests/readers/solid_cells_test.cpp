// Every solid cell as Gmsh, Abaqus and VTK list its vertices: it is read in the order of fem/cell.hpp.
#include <gtest/gtest.h>

#include <cmath>

#include "readers/fixture.hpp"
#include "ritz/fem/geometry.hpp"

namespace ritz::readers::testing {
namespace {

using Corners = std::vector<std::array<double, 3>>;

/// A cell as the formats list it.
struct Listed {
  fem::CellType type;
  int gmsh, vtk;
  const char* abaqus;
  Corners corners;                               ///< in the order of Gmsh and Abaqus
  std::vector<std::array<int, 2>> gmsh_middles;  ///< between these corners
  std::vector<std::array<int, 2>> abaqus_middles;
  std::vector<std::vector<int>> faces;  ///< S1, S2, … of Abaqus by their corners
  double volume;
};

const Corners box_corners = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
const Corners prism_corners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}};
const std::vector<std::vector<int>> hex_faces = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5},
                                                 {1, 2, 5, 6}, {2, 3, 6, 7}, {3, 0, 7, 4}};
const std::vector<std::vector<int>> wedge_faces = {{0, 1, 2}, {3, 4, 5}, {0, 1, 3, 4}, {1, 2, 4, 5}, {2, 0, 5, 3}};

const Listed cells[] = {
    {fem::CellType::hex8, 5, 12, "C3D8", box_corners, {}, {}, hex_faces, 8},
    {fem::CellType::hex20,
     17,
     25,
     "C3D20",
     box_corners,
     {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}},
     {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}},
     hex_faces,
     8},
    {fem::CellType::wedge6, 6, 13, "C3D6", prism_corners, {}, {}, wedge_faces, 4},
    {fem::CellType::wedge15,
     18,
     26,
     "C3D15",
     prism_corners,
     {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
     {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
     wedge_faces,
     4},
    {fem::CellType::pyramid5,
     7,
     14,
     "C3D5",
     {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}},
     {},
     {},
     {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
     4}};

/// The vertices as a format lists them.
Corners with_middles(const Listed& cell, const std::vector<std::array<int, 2>>& middles) {
  Corners points = cell.corners;
  for (const auto& [a, b] : middles) {
    std::array<double, 3> between_two;
    for (std::size_t i = 0; i < 3; ++i)
      between_two[i] =
          (cell.corners[static_cast<std::size_t>(a)][i] + cell.corners[static_cast<std::size_t>(b)][i]) / 2;
    points.push_back(between_two);
  }
  return points;
}

std::string joined(const Corners& points, const std::string& between, bool numbered) {
  std::string text;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (numbered) text += std::to_string(v + 1) + between;
    for (std::size_t i = 0; i < 3; ++i) text += std::to_string(points[v][i]) + (i < 2 ? between : "\n");
  }
  return text;
}

std::string counted(std::size_t count, std::size_t first, const std::string& between) {
  std::string text;
  for (std::size_t v = 0; v < count; ++v) text += (v == 0 ? "" : between) + std::to_string(first + v);
  return text;
}

std::string msh(const Listed& cell) {
  const auto points = with_middles(cell, cell.gmsh_middles);
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(points.size()) + "\n" +
         joined(points, " ", true) + "$EndNodes\n$Elements\n1\n1 " + std::to_string(cell.gmsh) + " 2 1 1 " +
         counted(points.size(), 1, " ") + "\n$EndElements\n";
}

std::string inp(const Listed& cell) {
  const auto points = with_middles(cell, cell.abaqus_middles);
  std::string text = "*NODE\n" + joined(points, ", ", true) + "*ELEMENT, TYPE=" + cell.abaqus + ", ELSET=body\n1,\n" +
                     counted(points.size(), 1, ",\n") + "\n";
  for (std::size_t f = 1; f <= cell.faces.size(); ++f)
    text += "*SURFACE, NAME=side" + std::to_string(f) + "\nbody, S" + std::to_string(f) + "\n";
  return text;
}

/// `outward`: a wedge's first triangle as VTK documents it, else as Gmsh lists it.
std::string vtu(const Listed& cell, bool outward) {
  auto points = with_middles(cell, cell.abaqus_middles);
  if (outward && cell.corners.size() == 6) {
    std::swap_ranges(points.begin(), points.begin() + 3, points.begin() + 3);
    if (points.size() > 6) std::swap_ranges(points.begin() + 6, points.begin() + 9, points.begin() + 9);
  }
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"" +
         std::to_string(points.size()) +
         "\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">" +
         joined(points, " ", false) + "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">" +
         counted(points.size(), 0, " ") + "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">" +
         std::to_string(points.size()) + "</DataArray><DataArray type=\"Int16\" Name=\"types\">" +
         std::to_string(cell.vtk) + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

fem::CellVectors vertices(const FileMesh& mesh) {
  fem::CellVectors x(3, static_cast<int>(mesh.cell_vertices.size()));
  for (int a = 0; a < x.cols(); ++a) {
    const auto v = static_cast<std::size_t>(mesh.cell_vertices[static_cast<std::size_t>(a)]);
    for (int i = 0; i < 3; ++i) x(i, a) = mesh.points[v][static_cast<std::size_t>(i)];
  }
  return x;
}

void expect_sound(const Listed& cell, const FileMesh& mesh) {
  expect_consistent(mesh);
  ASSERT_EQ(mesh.cell_types, std::vector(1, cell.type));
  const auto x = vertices(mesh);
  EXPECT_NEAR(fem::volume(cell.type, x), cell.volume, 1e-14 * cell.volume);
  EXPECT_GT(fem::smallest_jacobian(cell.type, x), 0);
  EXPECT_TRUE(fem::straight(cell.type, x));  // every mid-edge vertex lies on its edge
}

TEST(SolidCells, OfGmshArePutIntoOurOrder) {
  for (const auto& cell : cells) {
    SCOPED_TRACE(cell.abaqus);
    expect_sound(cell, read_text("a.msh", msh(cell)));
  }
}

TEST(SolidCells, OfVtkHavePositiveVolumesWhicheverWayTheirTrianglesTurn) {
  for (const auto& cell : cells) {
    SCOPED_TRACE(cell.abaqus);
    expect_sound(cell, read_text("a.vtu", vtu(cell, false)));
    expect_sound(cell, read_text("a.vtu", vtu(cell, true)));
  }
}

TEST(SolidCells, OfAbaqusArePutIntoOurOrderAndTheirFacesAreItsFaces) {
  for (const auto& cell : cells) {
    SCOPED_TRACE(cell.abaqus);
    const auto mesh = read_text("a.inp", inp(cell));
    expect_sound(cell, mesh);
    for (std::size_t f = 0; f < cell.faces.size(); ++f) {
      SCOPED_TRACE("S" + std::to_string(f + 1));
      const auto* set = find_set(mesh, "side" + std::to_string(f + 1));
      ASSERT_TRUE(set);
      ASSERT_EQ(set->faces.size(), 1u);
      const auto shape = fem::shape(set->faces[0].type);
      EXPECT_EQ(set->vertices.size(), static_cast<std::size_t>(shape.vertices));
      std::vector<Index> corners(set->faces[0].vertices.begin(), set->faces[0].vertices.begin() + shape.corners);
      std::sort(corners.begin(), corners.end());
      std::vector<Index> expected(cell.faces[f].begin(), cell.faces[f].end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(corners, expected);
    }
  }
}

TEST(SolidCells, OfReducedIntegrationNeedTheUsersWord) {
  std::string text = inp(cells[1]);
  text.replace(text.find("C3D20"), 5, "C3D20R");
  EXPECT_NE(error_of("a.inp", text).find("'-ignore C3D20R' reads it as C3D20"), std::string::npos);
  expect_sound(cells[1], read_text("a.inp", text, {"C3D20R"}));
}

}  // namespace
}  // namespace ritz::readers::testing
