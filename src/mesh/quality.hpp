// Checks of the cells of a mesh: errors and warnings.
#pragma once
#include <string>
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

/// *Collective*. Throws InputError on all ranks when a cell has a Jacobian determinant <= 0 at a quadrature point or,
/// if its edges are straight, at a corner. The message names the first such cell, their number, and the mid-edge
/// vertices if these alone fold the cell.
void refuse_inverted_cells(const Mesh& mesh);

/// *Collective*. Warnings, one sentence each, the same on all ranks: notes of the file's reader, cells that mid-edge
/// vertices fold at a corner, slivers under 1 degree, dropped vertices, faces that do not conform, several pieces.
std::vector<std::string> warnings(const Mesh& mesh);

}  // namespace ritz::mesh
