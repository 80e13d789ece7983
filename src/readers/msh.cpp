#include "ritz/readers/msh_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "ritz/readers/formats.hpp"

namespace ritz::readers {

namespace {

const char* unsupported(Index type) {
  switch (type) {
    case 10: return "a quadrilateral with 9 vertices";
    case 12: return "a hexahedron with 27 vertices";
    case 13: return "a prism with 18 vertices";
    case 14: return "a pyramid with 14 vertices";
    case 19: return "a pyramid with 13 vertices";
    case 29: return "a tetrahedron with 20 vertices";
    case 30: return "a tetrahedron with 35 vertices";
    case 31: return "a tetrahedron with 56 vertices";
    case 92: return "a hexahedron with 64 vertices";
    default: return "of a kind ritz does not know";
  }
}

/// Gmsh's order of the edges on which mid-edge vertices lie, where it is not that of fem/cell.hpp.
constexpr fem::Edge tet_edges[] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
constexpr fem::Edge hex_edges[] = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                   {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
constexpr fem::Edge wedge_edges[] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};

std::span<const fem::Edge> msh_edges(fem::CellType quadratic) {
  switch (quadratic) {
    case fem::CellType::tet10: return tet_edges;
    case fem::CellType::hex20: return hex_edges;
    case fem::CellType::wedge15: return wedge_edges;
    default: return {};
  }
}

}  // namespace

Shape msh_shape(const MshInput& input, Index type) {
  if (type == 15) return point;
  if (type == 1) return line2;
  if (type == 8) return line3;
  for (const auto cell : fem::cell_types)
    if (fem::shape(cell).gmsh == type) return Shape::of(cell);
  for (const auto face : fem::face_types)
    if (fem::shape(face).gmsh == type) return Shape::of(face);
  input.fail("Gmsh element type " + std::to_string(type) + " is " + unsupported(type) +
             "; mesh with order 1, or with order 2 and Mesh.SecondOrderIncomplete = 1");
}

void reorder_from_msh(Shape shape, std::span<Index> vertices) {
  const auto theirs = shape.cell ? msh_edges(*shape.cell) : std::span<const fem::Edge>();
  if (theirs.empty()) return turn_wedge(shape, vertices);
  const auto cell = fem::shape(*shape.cell);
  const auto ours = cell.edges;
  const int corners = cell.corners;
  std::array<Index, fem::max_cell_vertices> middles;
  for (std::size_t e = 0; e < ours.size(); ++e) {
    const auto [a, b] = ours[e];
    const auto at = std::find_if(theirs.begin(), theirs.end(), [&](const fem::Edge& edge) {
      return edge == fem::Edge{a, b} || edge == fem::Edge{b, a};
    });
    middles[e] = vertices[static_cast<std::size_t>(corners + (at - theirs.begin()))];
  }
  std::copy_n(middles.begin(), ours.size(), vertices.begin() + corners);
  turn_wedge(shape, vertices);
}

void join_physical(Groups& groups, ListedMesh& mesh, Index tag) {
  if (tag != 0) join_group(groups, mesh, std::abs(tag));
}

void read_physical_names(MshInput& input, Groups& groups) {
  auto& cursor = input.cursor;
  cursor.skip_space();
  const Index count = cursor.integer("the number of physical names");
  cursor.end_line();
  MshInput{cursor}.check_count(count, "physical names", 3);
  for (Index i = 0; i < count; ++i) {
    cursor.skip_space();
    const Index dimension = cursor.integer("the dimension of a physical name");
    const Index tag = cursor.integer("the number of a physical group");
    if (dimension < 0 || dimension > 3) cursor.fail("the dimension of a physical group must be 0 to 3");
    const auto here = cursor;
    const auto quoted = cursor.line();
    if (quoted.size() < 3 || quoted.front() != '"' || quoted.back() != '"') {
      here.fail("expected the name of a physical group in double quotes");
    }
    groups.names[{static_cast<int>(dimension), tag}] = quoted.substr(1, quoted.size() - 2);
  }
  input.close_section("PhysicalNames");
}

namespace {

enum class Version { v2, v4 };

struct Section {
  std::string name;
  Place place;
};

// The next section, past its first line. What stands between sections is no one's.
std::optional<Section> next_section(Cursor& cursor) {
  while (!cursor.at_end()) {
    const auto place = cursor.place();
    const auto line = cursor.line();
    if (line.starts_with('$')) return Section{.name = std::string(line.substr(1)), .place = place};
  }
  return std::nullopt;
}

// $MeshFormat: "4.1 0 8", and in binary files the number one.
Version read_format(Sources& sources, unsigned file, MshInput& input) {
  auto& cursor = input.cursor;
  cursor.skip_space();
  const auto here = cursor;
  const double version = cursor.real("the version of the format");
  const Index binary = cursor.integer("0 for text or 1 for binary");
  const Index size = cursor.integer("the size of a number");
  if (version != 2.2 && version != 4.1) {
    std::ostringstream number;
    number << version;
    here.fail("version " + number.str() + " of the Gmsh format is not supported; save the mesh as version 4.1 or 2.2");
  }
  if (binary != 0 && binary != 1) here.fail("expected 0 (text) or 1 (binary) after the version");
  if (size != 8) here.fail("numbers of " + std::to_string(size) + " bytes are not supported, only of 8");
  cursor.end_line();
  if (binary == 1) {
    cursor.line();
    sources[file].counting = Counting::bytes;
    input.encoding = MshEncoding::binary;
    const auto order = input;
    if (input.integer("the byte order") != 1) order.fail("written in another byte order; save it as text");
  }
  return version == 4.1 ? Version::v4 : Version::v2;
}

// Sections that say nothing of the body: results, and what a mesh generator remembers of its geometry.
bool is_harmless(const std::string& name) {
  constexpr std::array names =
      std::to_array<std::string_view>({"Comments", "NodeData", "ElementData", "ElementNodeData", "InterpolationScheme",
                                       "Periodic", "GhostElements", "Parametrizations"});
  return std::find(names.begin(), names.end(), name) != names.end();
}

void read_section(const Sources& sources, MshFile& msh, Version version, const Section& section,
                  const Ignored& ignored) {
  const auto& name = section.name;
  const auto is = [&](const char* section, Version its) { return name == section && version == its; };
  if (name == "PhysicalNames") read_physical_names(msh.input, msh.groups);
  else if (is("Nodes", Version::v2)) read_msh2_nodes(msh);
  else if (is("ParametricNodes", Version::v2)) read_msh2_parametric_nodes(msh);
  else if (is("Elements", Version::v2)) read_msh2_elements(msh);
  else if (is("Entities", Version::v4)) read_msh4_entities(msh);
  else if (is("PartitionedEntities", Version::v4)) read_msh4_partitioned_entities(msh);
  else if (is("Nodes", Version::v4)) read_msh4_nodes(msh);
  else if (is("Elements", Version::v4)) read_msh4_elements(msh);
  else {
    if (!is_harmless(name))
      leave_out(sources, section.place, upper(name), "$" + name + " is not a section that ritz knows", ignored,
                msh.mesh);
    skip_msh_section(sources, msh.input, name, section.place);
  }
}

}  // namespace

FileMesh read_msh(Sources& sources, unsigned file, const Ignored& ignored) {
  MshFile msh{.input = {.cursor = Cursor(sources, file)}, .mesh = {}, .groups = {}, .entities = {}};
  auto& cursor = msh.input.cursor;
  msh.memberships_left = cursor.remaining();
  std::optional<Version> version;
  while (const auto section = next_section(cursor)) {
    if (section->name == "MeshFormat") {
      version = read_format(sources, file, msh.input);
      msh.input.close_section("MeshFormat");
    } else if (section->name == "Comments") {
      skip_msh_section(sources, msh.input, section->name, section->place);
    } else if (version) {
      read_section(sources, msh, *version, *section, ignored);
    } else {
      fail(sources, section->place, "expected $MeshFormat first; is this a Gmsh mesh of version 2.2 or 4.1?");
    }
  }
  if (!version) fail(sources, "the file has no $MeshFormat; it is not a Gmsh mesh of version 2.2 or 4.1");
  name_groups(msh.groups, msh.mesh);
  return finish(sources, std::move(msh.mesh));
}

}  // namespace ritz::readers
