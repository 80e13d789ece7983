#include "ritz/algebra/graph_partition.hpp"

#include <petscmat.h>

#include <algorithm>

#include "ritz/algebra/check.hpp"

namespace ritz::algebra {

using Partitioning = Handle<MatPartitioning, MatPartitioningDestroy>;

std::vector<std::int32_t> partition_graph(MPI_Comm comm, const std::vector<PetscInt>& starts,
                                          const std::vector<PetscInt>& columns, PetscInt total) {
  // The matrix frees its two arrays with PetscFree, so it gets copies of PETSc's own.
  PetscInt *i = nullptr, *j = nullptr;
  check(PetscMalloc1(starts.size(), &i));
  check(PetscMalloc1(columns.size(), &j));
  std::copy(starts.begin(), starts.end(), i);
  std::copy(columns.begin(), columns.end(), j);
  const auto rows = static_cast<PetscInt>(starts.size()) - 1;
  Matrix graph;
  check(MatCreateMPIAdj(comm, rows, total, i, j, nullptr, graph.out()));
  Partitioning partitioning;
  check(MatPartitioningCreate(comm, partitioning.out()));
  check(MatPartitioningSetAdjacency(partitioning, graph));
  check(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
  IndexSet parts;
  check(MatPartitioningApply(partitioning, parts.out()));
  const PetscInt* numbers = nullptr;
  check(ISGetIndices(parts, &numbers));
  std::vector<std::int32_t> result(numbers, numbers + rows);
  check(ISRestoreIndices(parts, &numbers));
  return result;
}

}  // namespace ritz::algebra
