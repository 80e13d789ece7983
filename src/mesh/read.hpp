// From a mesh option to a distributed mesh.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "ritz/mesh/box.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/units.hpp"

namespace ritz::mesh {

enum class Partitioner { metis, ptscotch };

struct Source {
  std::variant<std::filesystem::path, Box> mesh;
  Units units;
  Partitioner partitioner = Partitioner::metis;
  Ignored ignored;                                  ///< of the mesh file, on the user's word
  std::vector<std::filesystem::path> vertex_lists;  ///< .bou files: each becomes a set named by its path
};

/// Reads or generates the mesh and distributes it. Throws InputError on all ranks for a wrong file, a cell turned
/// inside out, or a non-finite coordinate. *Collective*.
Mesh read(MPI_Comm comm, const Source& source);

}  // namespace ritz::mesh
