// Gmsh's element types and physical groups.
#pragma once
#include "ritz/mesh/read_groups.hpp"
#include "ritz/mesh/read_msh_input.hpp"

namespace ritz::mesh {

/// The shape of Gmsh's element type `type`. Throws InputError naming a type that ritz has no element for.
Shape msh_shape(const MshInput& input, Index type);

/// Turns Gmsh's order of a cell's vertices into that of fem/cell.hpp.
void reorder_from_msh(Shape shape, std::span<Index> vertices);

/// Puts the cell listed last into a physical group; tag 0 is none, a negative one its reverse.
void join_physical(Groups& groups, ListedMesh& mesh, Index tag);

/// The body of $PhysicalNames.
void read_physical_names(MshInput& input, Groups& groups);

}  // namespace ritz::mesh
