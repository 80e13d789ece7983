// Gmsh's .msh files, versions 2.2 and 4.1, text and binary.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

/// Reads source `file`. A physical volume is a region and a set; the other physical groups are sets; a group without
/// a name is named by its number. A cell in several physical volumes belongs to the region listed first. A set that
/// volumes share a name with is the one of lower dimension. Throws InputError.
FileMesh read_msh(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::mesh
