// The named sets of a listed mesh.
#pragma once
#include "ritz/mesh/read_listed.hpp"

namespace ritz::mesh {

/// Every set that is not empty, as vertices and faces. `mesh.cell_vertices` holds positions.
std::vector<NamedSet> gather_sets(const ListedMesh& mesh);

}  // namespace ritz::mesh
