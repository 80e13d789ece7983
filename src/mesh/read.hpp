// Reads or generates a mesh and distributes it.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "ritz/mesh/box.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/readers/units.hpp"

namespace ritz::mesh {

using readers::ignored_word;
using readers::parse_units;
using readers::Units;

/// What to read or to generate, and how to distribute it.
struct Source {
  std::variant<std::filesystem::path, Box> mesh;
  Units units;
  Partitioner partitioner = Partitioner::metis;
  Ignored ignored;                                  ///< what of the mesh file the user asked to ignore
  std::vector<std::filesystem::path> vertex_lists;  ///< .bou files; each becomes a set with its path as name
};

/// *Collective*. Reads or generates the mesh and distributes it. Throws InputError on all ranks for a wrong file, an
/// inverted cell, or a coordinate that is not finite.
Mesh read(MPI_Comm comm, const Source& source);

}  // namespace ritz::mesh
