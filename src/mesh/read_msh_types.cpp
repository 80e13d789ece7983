#include "ritz/mesh/read_msh_types.hpp"

#include <algorithm>
#include <cstdlib>

namespace ritz::mesh {
namespace {

const char* unsupported(Index type) {
  switch (type) {
    case 6: return "a prism with 6 vertices";
    case 7: return "a pyramid with 5 vertices";
    case 10: return "a quadrilateral with 9 vertices";
    case 12: return "a hexahedron with 27 vertices";
    case 13: return "a prism with 18 vertices";
    case 14: return "a pyramid with 14 vertices";
    case 16: return "a quadrilateral with 8 vertices";
    case 17: return "a hexahedron with 20 vertices";
    case 18: return "a prism with 15 vertices";
    case 19: return "a pyramid with 13 vertices";
    case 29: return "a tetrahedron with 20 vertices";
    case 30: return "a tetrahedron with 35 vertices";
    case 31: return "a tetrahedron with 56 vertices";
    case 92: return "a hexahedron with 64 vertices";
    default: return "of a kind ritz does not know";
  }
}

}  // namespace

Shape msh_shape(const MshInput& input, Index type) {
  switch (type) {
    case 1: return Shape::line2;
    case 2: return Shape::tri3;
    case 3: return Shape::quad4;
    case 4: return Shape::tet4;
    case 5: return Shape::hex8;
    case 8: return Shape::line3;
    case 9: return Shape::tri6;
    case 11: return Shape::tet10;
    case 15: return Shape::point;
    default:
      input.fail("Gmsh element type " + std::to_string(type) + " is " + unsupported(type) +
                 "; mesh with tetrahedra of order 1 or 2 or hexahedra of order 1");
  }
}

void reorder_from_msh(Shape shape, std::span<Index> vertices) {
  // Gmsh lists the middles of edges 23 and 13 in this order, everybody else 13 and 23.
  if (shape == Shape::tet10) std::swap(vertices[8], vertices[9]);
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

}  // namespace ritz::mesh
