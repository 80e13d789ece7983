// Decides which rank gets which cell, and distributes the mesh from rank 0.
#pragma once
#include <mpi.h>
#include <array>
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/mesh/topology.hpp"

namespace ritz::mesh {

/// *Collective*. Distributes the mesh of rank 0 (the argument of the other ranks is ignored) and returns the part of
/// this rank.
std::pair<Part, Shared> distribute(MPI_Comm comm, const FileMesh& mesh, Partitioner partitioner);

/// Removes the vertices that no cell uses from the mesh and from its sets; returns their number.
Index drop_unused_vertices(FileMesh& mesh);

/// The rank of each cell, by METIS (serial, k-way) from the pairs of cells that share a face. Some ranks may get no
/// cells.
std::vector<std::int32_t> partition_metis(Index cells, const std::vector<std::array<Index, 2>>& neighbours, int ranks);

/// *Collective*. The same by PT-Scotch on all ranks; rank 0 passes the graph and gets the result.
std::vector<std::int32_t> partition_ptscotch(MPI_Comm comm, Index cells,
                                             const std::vector<std::array<Index, 2>>& neighbours);

}  // namespace ritz::mesh
