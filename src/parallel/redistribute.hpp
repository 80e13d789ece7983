// Redistributes rows between two layouts: each rank holds the rows of its own vertices, or a contiguous slice in the
// order of the mesh file.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The slice [first, first + count) of `total` rows that one rank holds.
struct Slice {
  std::int64_t first;
  std::int64_t count;
  std::int64_t total;
};

/// The slice of this rank if `total` rows are divided evenly among the ranks.
Slice even_slice(MPI_Comm comm, std::int64_t total);

/// The rank whose even slice holds `row`.
int slice_owner(int ranks, std::int64_t total, std::int64_t row);

/// *Collective*. Row i of `values` is row numbers[i] of the whole; each number 0 ... total-1 occurs on exactly one
/// rank. Returns the even slice of this rank, in order.
RowMatrix to_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& values, std::int64_t total);

/// *Collective*. The inverse: each rank passes its even slice of `total` rows, and gets the rows `numbers` in the order
/// of these.
RowMatrix from_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& slice, std::int64_t total);

/// *Collective*. Sorts rows of `width` integers by keys 0 ... keys-1; each key occurs on at most one rank, and keys may
/// be missing. Returns the rows whose keys lie in this rank's even slice of the keys, by ascending key.
std::vector<std::int64_t> sorted_by_key(MPI_Comm comm, std::span<const std::int64_t> row_keys,
                                        std::span<const std::int64_t> values, int width, std::int64_t keys);

}  // namespace ritz::parallel
