// Which rank gets which cell.
#pragma once
#include <mpi.h>

#include <array>
#include <vector>

#include "ritz/mesh/file_mesh.hpp"

namespace ritz::mesh {

/// The rank of each cell, from the graph of cells that share a face, by METIS (serial, k-way). Ranks may stay empty.
std::vector<std::int32_t> partition_metis(Index cells, const std::vector<std::array<Index, 2>>& neighbours, int ranks);

/// The same by PT-Scotch on all ranks; rank 0 gives the graph and gets the result. *Collective*.
std::vector<std::int32_t> partition_ptscotch(MPI_Comm comm, Index cells,
                                             const std::vector<std::array<Index, 2>>& neighbours);

}  // namespace ritz::mesh
