// Parallel graph partitioning.
#pragma once
#include <cstdint>
#include <vector>

#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// *Collective*. Partitions a graph by PT-Scotch into as many parts as ranks. Each rank passes its slice of the rows in
/// compressed form, and gets the part of each of these rows.
std::vector<std::int32_t> partition_graph(MPI_Comm comm, const std::vector<PetscInt>& starts,
                                          const std::vector<PetscInt>& columns, PetscInt total);

}  // namespace ritz::petsc
