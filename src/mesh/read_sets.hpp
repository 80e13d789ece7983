// The named sets of a listed mesh.
#pragma once
#include "ritz/mesh/read_listed.hpp"

namespace ritz::mesh {

/// Sets of several kinds that share one name become "KIND:NAME" each, with a note that says what the name alone means.
/// Throws InputError where that is the name of another set.
void tell_kinds_apart(const Sources& sources, ListedMesh& mesh);

/// Every set that is not empty, as vertices and faces. `mesh.cell_vertices` holds positions.
std::vector<NamedSet> gather_sets(const ListedMesh& mesh);

}  // namespace ritz::mesh
