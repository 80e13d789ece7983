// From the whole mesh on rank 0 to each rank's part, and which rank gets which cell.
#pragma once
#include <mpi.h>
#include <array>
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/mesh/topology.hpp"

namespace ritz::mesh {

/// Rank 0 gives the mesh (the others' argument is not looked at); every rank gets its part. *Collective*.
std::pair<Part, Shared> distribute(MPI_Comm comm, const FileMesh& mesh, Partitioner partitioner);

/// Removes vertices that no cell uses from the mesh and from its sets; returns how many.
Index drop_unused_vertices(FileMesh& mesh);

/// The rank of each cell, from the graph of cells that share a face, by METIS (serial, k-way). Ranks may stay empty.
std::vector<std::int32_t> partition_metis(Index cells, const std::vector<std::array<Index, 2>>& neighbours, int ranks);

/// The same by PT-Scotch on all ranks; rank 0 gives the graph and gets the result. *Collective*.
std::vector<std::int32_t> partition_ptscotch(MPI_Comm comm, Index cells,
                                             const std::vector<std::array<Index, 2>>& neighbours);

}  // namespace ritz::mesh
