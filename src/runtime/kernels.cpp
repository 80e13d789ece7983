#include "kernels.hpp"

#include "simd.hpp"

namespace ritz::runtime {
namespace {

using Index = std::ptrdiff_t;

template <class Scalar>
RITZ_INLINE Scalar sum(const Pack<Scalar>& v) {
  Scalar total = 0;
  for (Index i = 0; i < lanes<Scalar>; ++i) total += v[i];
  return total;
}

/// One group of four rows: the four dot products with x are added to y, and so is the rows' combination.
template <int vectors, class Scalar>
RITZ_INLINE const Scalar* multiply_group(Index row, Index pairs, const Scalar* tiles, const Scalar* x, Scalar* y) {
  constexpr Index width = lanes<Scalar>;
  Pack<Scalar> dot[vectors][tile_rows] = {}, factor[vectors][tile_rows];
  for (int v = 0; v < vectors; ++v)
    for (int q = 0; q < tile_rows; ++q) factor[v][q] = Pack<Scalar>{} + x[v * pairs + row + q];
  for (Index column = row / width * width; column < pairs; column += width, tiles += tile_rows * width) {
    const auto* tile = packs(tiles);
    for (int v = 0; v < vectors; ++v) {
      const auto here = *packs(x + v * pairs + column);
      auto& to = *packs(y + v * pairs + column);
      for (int q = 0; q < tile_rows; ++q) dot[v][q] += tile[q] * here;
      to += (tile[0] * factor[v][0] + tile[1] * factor[v][1]) + (tile[2] * factor[v][2] + tile[3] * factor[v][3]);
    }
  }
  for (int v = 0; v < vectors; ++v)
    for (int q = 0; q < tile_rows; ++q) y[v * pairs + row + q] += sum<Scalar>(dot[v][q]);
  return tiles;
}

template <int vectors, class Scalar>
RITZ_INLINE void multiply(Index pairs, const Scalar* tiles, const Scalar* x, Scalar* y) {
  for (Index row = 0; row < pairs; row += tile_rows) tiles = multiply_group<vectors>(row, pairs, tiles, x, y);
}

/// Each coefficient serves one instance a lane: no sums across a register, and x and y stay in the nearest cache.
template <class Scalar>
RITZ_INLINE void multiply_lanes(Index pairs, const Scalar* tiles, const Scalar* x, Scalar* y) {
  constexpr Index width = lanes<Scalar>;
  const auto* from = packs(x);
  auto* to = packs(y);
  for (Index row = 0; row < pairs; row += tile_rows) {
    Pack<Scalar> dot[tile_rows] = {}, factor[tile_rows];
    for (int q = 0; q < tile_rows; ++q) factor[q] = from[row + q];
    for (Index column = row / width * width; column < pairs; column += width, tiles += tile_rows * width)
      for (Index e = 0; e < width; ++e) {
        const Scalar* c = tiles + e;
        const auto here = from[column + e];
        for (int q = 0; q < tile_rows; ++q) dot[q] += c[q * width] * here;
        to[column + e] +=
            (c[0] * factor[0] + c[width] * factor[1]) + (c[2 * width] * factor[2] + c[3 * width] * factor[3]);
      }
    for (int q = 0; q < tile_rows; ++q) to[row + q] += dot[q];
  }
}

/// Four columns at a time, so that y is loaded and stored once for four.
template <class Scalar>
RITZ_INLINE void multiply_by_columns(Index pairs, Index r, const Scalar* M, const Scalar* z, Scalar* y) {
  constexpr Index width = lanes<Scalar>;
  Index k = 0;
  for (; k + 4 <= r; k += 4, M += 4 * pairs)
    for (Index p = 0; p < pairs; p += width)
      *packs(y + p) += (*packs(M + p) * z[k] + *packs(M + pairs + p) * z[k + 1]) +
                       (*packs(M + 2 * pairs + p) * z[k + 2] + *packs(M + 3 * pairs + p) * z[k + 3]);
  for (; k < r; ++k, M += pairs)
    for (Index p = 0; p < pairs; p += width) *packs(y + p) += *packs(M + p) * z[k];
}

}  // namespace

RITZ_WIDE void multiply_symmetric(Index pairs, const double* tiles, const double* x, double* y) {
  multiply<1>(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_symmetric(Index pairs, const float* tiles, const float* x, float* y) {
  multiply<1>(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_symmetric_twice(Index pairs, const double* tiles, const double* x, double* y) {
  multiply<2>(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_symmetric_twice(Index pairs, const float* tiles, const float* x, float* y) {
  multiply<2>(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_symmetric_lanes(Index pairs, const double* tiles, const double* x, double* y) {
  multiply_lanes(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_symmetric_lanes(Index pairs, const float* tiles, const float* x, float* y) {
  multiply_lanes(pairs, tiles, x, y);
}
RITZ_WIDE void multiply_columns(Index pairs, Index r, const double* M, const double* z, double* y) {
  multiply_by_columns(pairs, r, M, z, y);
}
RITZ_WIDE void multiply_columns(Index pairs, Index r, const float* M, const float* z, float* y) {
  multiply_by_columns(pairs, r, M, z, y);
}

}  // namespace ritz::runtime
