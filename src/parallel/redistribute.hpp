// From "each rank holds the rows of its own vertices" to "each rank holds a contiguous slice in the mesh file's order".
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The slice [first, first + count) of `total` rows that belongs to one rank.
struct Slice {
  std::int64_t first;
  std::int64_t count;
  std::int64_t total;
};

/// An even cut of `total` rows into one slice a rank.
Slice even_slice(MPI_Comm comm, std::int64_t total);

/// The rank whose even slice holds `row`.
int slice_owner(int ranks, std::int64_t total, std::int64_t row);

/// rows[i] (a row of `values`) is row numbers[i] of the whole; each number 0 ... total-1 stands on exactly one rank.
/// Returns this rank's even slice, in order. *Collective*.
RowMatrix to_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& values, std::int64_t total);

/// The way back: each rank holds its even slice of `total` rows; returns rows `numbers`, in their order. *Collective*.
RowMatrix from_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& slice, std::int64_t total);

/// Rows of `width` integers by keys 0 ... keys-1, each key on at most one rank and not every key present: returns the
/// rows whose keys lie in this rank's even slice of the keys, in ascending order of keys. *Collective*.
std::vector<std::int64_t> sorted_by_key(MPI_Comm comm, std::span<const std::int64_t> row_keys,
                                        std::span<const std::int64_t> values, int width, std::int64_t keys);

}  // namespace ritz::parallel
