// The products of a cubature with the displacement gradients Γ of the columns of U, a few points at a time.
//
// `gradients` begins at the first of those points: for each point nine columns of `rows` numbers, the k-th number of
// column m being component m of the gradient of column k of U. `rows` is a multiple of two registers, and six numbers
// more can be read behind the last column.
#pragma once
#include <cstddef>

#include "ritz/base/simd.hpp"

namespace ritz::runtime {

/// The most points that one call takes.
inline constexpr std::ptrdiff_t most_points = 8;

/// The number of coordinates of a column with its zeros.
template <class Scalar>
constexpr std::ptrdiff_t padded(std::ptrdiff_t r) {
  return (r + 2 * lanes<Scalar> - 1) / (2 * lanes<Scalar>)*(2 * lanes<Scalar>);
}

/// The columns of a tangent that are computed: a multiple of the width of a block, six.
constexpr std::ptrdiff_t tangent_columns(std::ptrdiff_t r) { return (r + 5) / 6 * 6; }

/// G = Γ z: nine numbers a point.
void displacement_gradients(std::ptrdiff_t rows, std::ptrdiff_t points, const double* gradients, const double* z,
                            double* G);
void displacement_gradients(std::ptrdiff_t rows, std::ptrdiff_t points, const float* gradients, const float* z,
                            double* G);

/// force += Γᵀ P, with nine numbers of P a point, and `rows` numbers of the force.
void add_force(std::ptrdiff_t rows, std::ptrdiff_t points, const double* gradients, const double* P, double* force);
void add_force(std::ptrdiff_t rows, std::ptrdiff_t points, const float* gradients, const float* P, float* force);

/// tangent += Γᵀ A Γ, with A symmetric, 9 x 9 a point. Of `tangent`, rows x tangent_columns(r) column by column, the
/// lower triangle is complete, and the rest is of no use. `room` takes 9 rows numbers a point.
void add_tangent(std::ptrdiff_t rows, std::ptrdiff_t r, std::ptrdiff_t points, const double* gradients, const double* A,
                 double* room, double* tangent);
void add_tangent(std::ptrdiff_t rows, std::ptrdiff_t r, std::ptrdiff_t points, const float* gradients, const float* A,
                 float* room, float* tangent);

}  // namespace ritz::runtime
