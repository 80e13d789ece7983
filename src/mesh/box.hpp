// Generated meshes of boxes. They are made in parallel: each rank builds its own block of the grid.
#pragma once
#include <mpi.h>

#include <array>
#include <string>
#include <string_view>

#include "ritz/mesh/part.hpp"

namespace ritz::mesh {

/// A box [0, lengths] divided into cells[0] x cells[1] x cells[2] hexahedra, or each of those into Kuhn's six
/// tetrahedra or into two wedges. Vertices are numbered with x running fastest, then y, then z; those of quadratic
/// cells lie on the grid of half the spacing.
struct Box {
  std::array<double, 3> lengths;  ///< in the units of the mesh option
  std::array<Index, 3> cells;
  fem::CellType type;
};

/// Whether `text` describes a box: it begins with "box:".
bool names_box(std::string_view text);

/// Parses "box:LX,LY,LZ/NX,NY,NZ/tet4" (or tet10, hex8, hex20, wedge6, wedge15). Throws InputError.
Box parse_box(std::string_view text);

/// *Collective*. This rank's part of the mesh, with the face sets xmin, xmax, ymin, ymax, zmin, zmax and the region
/// "body".
std::pair<Part, Shared> make_box(MPI_Comm comm, const Box& box);

}  // namespace ritz::mesh
