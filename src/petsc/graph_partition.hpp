// Parallel graph partitioning.
#pragma once
#include <cstdint>
#include <vector>

#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// Cuts a graph, given by this rank's slice of its rows in compressed form, into one part a rank with PT-Scotch.
/// Returns the part of each row of the slice. *Collective*.
std::vector<std::int32_t> partition_graph(MPI_Comm comm, const std::vector<PetscInt>& starts,
                                          const std::vector<PetscInt>& columns, PetscInt total);

}  // namespace ritz::petsc
