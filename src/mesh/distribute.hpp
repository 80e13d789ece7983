// From the whole mesh on rank 0 to each rank's part.
#pragma once
#include "ritz/mesh/part.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/mesh/topology.hpp"

namespace ritz::mesh {

/// Rank 0 gives the mesh (the others' argument is not looked at); every rank gets its part. *Collective*.
std::pair<Part, Shared> distribute(MPI_Comm comm, const FileMesh& mesh, Partitioner partitioner);

/// Removes vertices that no cell uses from the mesh and from its sets; returns how many.
Index drop_unused_vertices(FileMesh& mesh);

}  // namespace ritz::mesh
