// Vega FEM's .veg files.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

/// Reads source `file`, its vertices and elements numbered from 0 or from 1. A region is named by its set, and where
/// regions overlap the later one wins; allElements is always a set. Throws InputError.
FileMesh read_veg(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::mesh
