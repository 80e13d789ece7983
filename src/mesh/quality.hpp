// What is wrong, or nearly wrong, with the cells of a mesh.
#pragma once
#include <string>
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

/// Throws InputError on all ranks when a cell has a Jacobian determinant <= 0 where it is integrated (a straight one:
/// or at a corner); names the first such cell and how many there are, and its mid-edge vertices where they alone fold
/// it. *Collective*.
void refuse_inverted_cells(const Mesh& mesh);

/// One sentence for each thing that a careful user would want to know: what the file's reader noted, cells that
/// mid-edge vertices fold at a corner, slivers under 1 degree, dropped vertices, faces that do not conform, several
/// pieces. Same on all ranks. *Collective*.
std::vector<std::string> warnings(const Mesh& mesh);

}  // namespace ritz::mesh
