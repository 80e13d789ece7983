// VTK's unstructured grids in XML, .vtu.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

/// Reads source `file`; its pieces are put one after the other. Vertices and cells are numbered from 0. An integer cell
/// array named region, Region, gmsh:physical, medit:ref, MaterialID or cell_tags makes regions (and sets) named by its
/// values; a point array of 8-bit integers is the set of its non-zero vertices. Throws InputError.
FileMesh read_vtu(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::mesh
