#include "ritz/readers/formats.hpp"

#include <algorithm>

#include "ritz/base/shown.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/readers/groups.hpp"
#include "ritz/readers/vtu_file.hpp"

namespace ritz::readers {

namespace {

constexpr const char* region_names[] = {"region", "Region", "gmsh:physical", "medit:ref", "MaterialID", "cell_tags"};

/// What the pieces of a file have in common.
struct VtuMesh {
  ListedMesh mesh;
  Groups groups;
  std::map<std::string, std::vector<Index>> vertex_sets;
};

struct PieceSize {
  Index points;
  Index cells;
};

pugi::xml_node named(const VtuFile& vtu, const pugi::xml_node& parent, const char* name) {
  const auto array = parent.find_child_by_attribute("DataArray", "Name", name);
  if (!array) vtu.fail(parent, std::string("has no DataArray named ") + name);
  return array;
}

Index components(const VtuFile& vtu, const pugi::xml_node& array) {
  return attribute(vtu, array, "NumberOfComponents", 1);
}

Index times(const VtuFile& vtu, const pugi::xml_node& node, Index count, Index each) {
  const auto size = static_cast<Index>(vtu.sources[vtu.file].bytes.size());
  // Even zlib cannot put more numbers than this into the file.
  if (count > 2000 * size) vtu.fail(node, "states more than can be in the file; it is truncated or wrong");
  return count * each;
}

[[noreturn]] void refuse_type(const VtuFile& vtu, const pugi::xml_node& node, const std::string& what) {
  vtu.fail(node, what +
                     " is not supported; ritz has tetrahedra (10, 24), hexahedra (11, 12, 25), wedges (13, 26) and "
                     "pyramids (14), Lagrange cells (71 to 74) of as many vertices, and lines, triangles and "
                     "quadrilaterals that only carry sets");
}

// VTK's Lagrange cells (68 to 74) have any order; those of them that ritz has list their vertices in the same order.
std::optional<Shape> lagrange_shape(Index type, Index vertices) {
  const auto of = [&](auto... types) {
    std::optional<Shape> shape;
    ((fem::shape(types).vertices == vertices ? void(shape = Shape::of(types)) : void()), ...);
    return shape;
  };
  switch (type) {
    case 68: return vertices == 2 ? std::optional(line2) : vertices == 3 ? std::optional(line3) : std::nullopt;
    case 69: return of(fem::FaceType::tri3, fem::FaceType::tri6);
    case 70: return of(fem::FaceType::quad4);
    case 71: return of(fem::CellType::tet4, fem::CellType::tet10);
    case 72: return of(fem::CellType::hex8);
    case 73: return of(fem::CellType::wedge6);
    case 74: return of(fem::CellType::pyramid5);
    default: return std::nullopt;
  }
}

Shape shape_of(const VtuFile& vtu, const pugi::xml_node& node, Index type, Index vertices) {
  switch (type) {
    case 1: return point;
    case 3: return line2;
    case 8: return Shape::of(fem::FaceType::quad4);  // a pixel
    case 11: return Shape::of(fem::CellType::hex8);  // a voxel
    case 21: return line3;
    default: break;
  }
  if (const auto cell = fem::cell_of_vtk(static_cast<int>(type))) return Shape::of(*cell);
  if (const auto face = fem::face_of_vtk(static_cast<int>(type))) return Shape::of(*face);
  const auto shape = lagrange_shape(type, vertices);
  if (!shape && type >= 68 && type <= 74)
    refuse_type(
        vtu, node,
        "a Lagrange cell (VTK type " + std::to_string(type) + ") with " + std::to_string(vertices) + " vertices");
  if (!shape) refuse_type(vtu, node, "VTK cell type " + std::to_string(type));
  return *shape;
}

// Pixels and voxels count along x, then y, then z, where quadrilaterals and hexahedra go around.
void reorder_from_vtk(Index type, std::span<Index> vertices) {
  if (type == 8 || type == 11) std::swap(vertices[2], vertices[3]);
  if (type == 11) std::swap(vertices[6], vertices[7]);
}

// By VTK's documentation the first triangle of a wedge is counter-clockwise seen from outside; many programs write it
// as Gmsh and Abaqus do, the other way round. The cell is taken so that its volume is positive.
void orient_wedge(const ListedMesh& mesh, Shape shape, std::span<Index> ids) {
  fem::CellVectors x(3, 6);
  for (int a = 0; a < 6; ++a)
    for (int i = 0; i < 3; ++i)
      x(i, a) = mesh.points[static_cast<std::size_t>(ids[static_cast<std::size_t>(a)])][static_cast<std::size_t>(i)];
  if (fem::volume(fem::CellType::wedge6, x) < 0) turn_wedge(shape, ids);
}

void read_points(const VtuFile& vtu, const pugi::xml_node& piece, const PieceSize& size, VtuMesh& to) {
  if (size.points == 0) return;
  const auto array = piece.child("Points").child("DataArray");
  if (!array) vtu.fail(piece, "has no <Points> with a DataArray");
  if (components(vtu, array) != 3) vtu.fail(array, "points must have 3 components");
  const auto values = reals(vtu, array, times(vtu, array, size.points, 3));
  const auto place = vtu.place(array);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const auto id = static_cast<Index>(to.mesh.points.size());
    add_vertex(to.mesh, id, {values[i], values[i + 1], values[i + 2]}, place);
  }
}

// The values of the first known region array of a piece; empty when it has none.
std::vector<Index> read_regions(const VtuFile& vtu, const pugi::xml_node& piece, const PieceSize& size) {
  const auto data = piece.child("CellData");
  for (const char* name : region_names) {
    const auto array = data.find_child_by_attribute("DataArray", "Name", name);
    if (array && is_integer(array) && components(vtu, array) == 1) return integers(vtu, array, size.cells);
  }
  return {};
}

void read_cells(const VtuFile& vtu, const pugi::xml_node& piece, const PieceSize& size, Index first_point,
                VtuMesh& to) {
  if (size.cells == 0) return;
  const auto cells = piece.child("Cells");
  if (!cells) vtu.fail(piece, "has no <Cells>");
  const auto type_array = named(vtu, cells, "types");
  const auto offset_array = named(vtu, cells, "offsets");
  const auto vertex_array = named(vtu, cells, "connectivity");
  const auto types = integers(vtu, type_array, times(vtu, type_array, size.cells, 1));
  const auto offsets = integers(vtu, offset_array, size.cells);
  if (offsets.back() < 0) vtu.fail(offset_array, "an offset is negative");
  const auto vertices = integers(vtu, vertex_array, offsets.back());
  const auto regions = read_regions(vtu, piece, size);
  const auto place = vtu.place(vertex_array);
  Index begin = 0;
  for (std::size_t c = 0; c < types.size(); ++c) {
    const auto id = static_cast<Index>(to.mesh.shapes.size());
    const bool ascending = offsets[c] >= begin && offsets[c] <= offsets.back();
    const auto shape = shape_of(vtu, type_array, types[c], ascending ? offsets[c] - begin : 0);
    if (!ascending || offsets[c] - begin != shape.vertices) {
      vtu.fail(offset_array, "cell " + std::to_string(id) + " does not have the vertices its type needs");
    }
    std::array<Index, fem::max_cell_vertices> ids;
    for (Index i = begin; i < offsets[c]; ++i) {
      const Index vertex = vertices[static_cast<std::size_t>(i)];
      const bool inside = vertex >= 0 && vertex < size.points;
      if (!inside)
        vtu.fail(vertex_array, "cell " + std::to_string(id) + " refers to vertex " + std::to_string(vertex) +
                                   ", which the file does not list");
      ids[static_cast<std::size_t>(i - begin)] = first_point + vertex;
    }
    reorder_from_vtk(types[c], ids);
    const auto own = std::span(ids).first(static_cast<std::size_t>(offsets[c] - begin));
    if (shape == Shape::of(fem::CellType::wedge6) || shape == Shape::of(fem::CellType::wedge15))
      orient_wedge(to.mesh, shape, own);
    add_cell(to.mesh, shape, id, own, place);
    if (!regions.empty()) join_group(to.groups, to.mesh, regions[c]);
    begin = offsets[c];
  }
}

// A cell that VTK marks as a duplicate of another piece's, or as hidden, is no cell of the body.
void refuse_ghosts(const VtuFile& vtu, const pugi::xml_node& piece, const PieceSize& size, const Ignored& ignored,
                   ListedMesh& mesh) {
  for (const std::string name : {"vtkGhostType", "vtkGhostLevels"}) {
    const auto array = piece.child("CellData").find_child_by_attribute("DataArray", "Name", name.c_str());
    if (!array || size.cells == 0) continue;
    const auto marks = integers(vtu, array, size.cells);
    const auto marked = std::count_if(marks.begin(), marks.end(), [](Index mark) { return mark != 0; });
    if (marked == 0) continue;
    leave_out(vtu.sources, vtu.place(array), upper(name),
              name + " marks " + counted(marked, "cell", "cells") +
                  " as duplicate or hidden, and ritz takes every cell as one of the body",
              ignored, mesh);
  }
}

void read_vertex_sets(const VtuFile& vtu, const pugi::xml_node& piece, const PieceSize& size, Index first_point,
                      VtuMesh& to) {
  for (const auto& array : piece.child("PointData").children("DataArray")) {
    const std::string name = array.attribute("Name").value();
    if (!is_byte(array) || components(vtu, array) != 1 || name.empty() || name == "vtkGhostType") continue;
    const auto members = integers(vtu, array, size.points);
    for (std::size_t v = 0; v < members.size(); ++v) {
      if (members[v] != 0) to.vertex_sets[name].push_back(first_point + static_cast<Index>(v));
    }
  }
}

void add_vertex_sets(VtuMesh& from) {
  for (auto& [name, vertices] : from.vertex_sets)
    from.mesh.sets.push_back(
        {.name = name, .vertices = std::move(vertices), .cells = {}, .faces = {}, .kind = "points"});
}

}  // namespace

FileMesh read_vtu(Sources& sources, unsigned file, const Ignored& ignored) {
  const auto vtu = open_vtu(sources, file);
  const auto grid = vtu.document.child("VTKFile").child("UnstructuredGrid");
  if (!grid) vtu.fail(vtu.document.child("VTKFile"), "has no <UnstructuredGrid>");
  VtuMesh result;
  for (const auto& piece : grid.children("Piece")) {
    const PieceSize size{.points = attribute(vtu, piece, "NumberOfPoints"),
                         .cells = attribute(vtu, piece, "NumberOfCells")};
    const auto first_point = static_cast<Index>(result.mesh.points.size());
    read_points(vtu, piece, size, result);
    read_cells(vtu, piece, size, first_point, result);
    refuse_ghosts(vtu, piece, size, ignored, result.mesh);
    read_vertex_sets(vtu, piece, size, first_point, result);
  }
  name_groups(result.groups, result.mesh);
  add_vertex_sets(result);
  return finish(sources, std::move(result.mesh));
}

}  // namespace ritz::readers
