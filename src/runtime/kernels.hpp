// The two products that an evaluation is made of. The symmetric one is over a matrix stored in tiles: rows in groups
// of four; of each group, columns from the one that holds the group's first on, a register's width at a time; in such
// a tile the four rows one after the other. Below the diagonal a tile is 0, and the diagonal itself is halved, so that
// y += U x + Uᵀ x is the whole product. Rows and columns number `pairs`, a multiple of a register's width.
#pragma once
#include <cstddef>

namespace ritz::runtime {

inline constexpr std::ptrdiff_t tile_rows = 4;

/// y_q += U x_q + Uᵀ x_q for one or two vectors, which stand `pairs` numbers apart.
void multiply_symmetric(std::ptrdiff_t pairs, const double* tiles, const double* x, double* y);
void multiply_symmetric(std::ptrdiff_t pairs, const float* tiles, const float* x, float* y);
void multiply_symmetric_twice(std::ptrdiff_t pairs, const double* tiles, const double* x, double* y);
void multiply_symmetric_twice(std::ptrdiff_t pairs, const float* tiles, const float* x, float* y);

/// The same for as many vectors as a register has numbers, which stand side by side: x and y are `pairs` registers.
void multiply_symmetric_lanes(std::ptrdiff_t pairs, const double* tiles, const double* x, double* y);
void multiply_symmetric_lanes(std::ptrdiff_t pairs, const float* tiles, const float* x, float* y);

/// y += M z, M of `pairs` x r column by column.
void multiply_columns(std::ptrdiff_t pairs, std::ptrdiff_t r, const double* M, const double* z, double* y);
void multiply_columns(std::ptrdiff_t pairs, std::ptrdiff_t r, const float* M, const float* z, float* y);

}  // namespace ritz::runtime
