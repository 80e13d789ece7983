// Parallel graph partitioning.
#pragma once
#include <cstdint>
#include <vector>

#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {

/// *Collective*. Partitions a graph by PT-Scotch into as many parts as ranks. Each rank passes its slice of the rows in
/// compressed form, and gets the part of each of these rows.
std::vector<std::int32_t> partition_graph(MPI_Comm comm, const std::vector<PetscInt>& starts,
                                          const std::vector<PetscInt>& columns, PetscInt total);

}  // namespace ritz::algebra
