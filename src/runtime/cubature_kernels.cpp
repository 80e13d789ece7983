#include "cubature_kernels.hpp"

namespace ritz::runtime {
namespace {

using Index = std::ptrdiff_t;

constexpr Index components_of_gradient = 9;
constexpr Index block = 6;  ///< columns of a tangent at a time: with two registers of rows, twelve sums

template <class Scalar>
RITZ_INLINE double sum_of(const Pack<Scalar>& pack) {
  Scalar sum = 0;
  for (Index e = 0; e < lanes<Scalar>; ++e) sum += pack[e];
  return static_cast<double>(sum);
}

template <class Scalar>
RITZ_INLINE void gradients_at(Index rows, Index points, const Scalar* gradients, const Scalar* z, double* G) {
  const Index width = rows / lanes<Scalar>;
  const Pack<Scalar>* coordinates = packs(z);
  for (Index p = 0; p < points; ++p, G += components_of_gradient) {
    const Pack<Scalar>* columns = packs(gradients) + p * components_of_gradient * width;
    for (Index m = 0; m < components_of_gradient; m += 3) {
      Pack<Scalar> a{}, b{}, c{};
      const Pack<Scalar>* from = columns + m * width;
      for (Index i = 0; i < width; ++i) {
        a += from[i] * coordinates[i];
        b += from[i + width] * coordinates[i];
        c += from[i + 2 * width] * coordinates[i];
      }
      G[m] = sum_of<Scalar>(a), G[m + 1] = sum_of<Scalar>(b), G[m + 2] = sum_of<Scalar>(c);
    }
  }
}

template <class Scalar>
RITZ_INLINE void force_at(Index rows, Index points, const Scalar* gradients, const Scalar* P, Scalar* force) {
  const Index width = rows / lanes<Scalar>;
  Pack<Scalar>* sums = packs(force);
  for (Index p = 0; p < points; ++p, P += components_of_gradient) {
    const Pack<Scalar>* columns = packs(gradients) + p * components_of_gradient * width;
    for (Index i = 0; i < width; ++i) {
      Pack<Scalar> sum = sums[i];
      for (Index m = 0; m < components_of_gradient; ++m) sum += columns[m * width + i] * P[m];
      sums[i] = sum;
    }
  }
}

/// The change of P by each coordinate, ΓᵀA, in columns as those of Γᵀ.
template <class Scalar>
RITZ_INLINE void changes_at(Index width, Index points, const Pack<Scalar>* columns, const Scalar* A,
                            Pack<Scalar>* changes) {
  constexpr Index nine = components_of_gradient;
  for (Index p = 0; p < points; ++p, A += nine * nine, columns += nine * width, changes += nine * width)
    for (Index i = 0; i < width; ++i) {
      Pack<Scalar> g[nine];
      for (Index n = 0; n < nine; ++n) g[n] = columns[n * width + i];
      for (Index m = 0; m < nine; ++m) {
        Pack<Scalar> sum = g[0] * A[nine * m];
        for (Index n = 1; n < nine; ++n) sum += g[n] * A[nine * m + n];
        changes[m * width + i] = sum;
      }
    }
}

template <class Scalar>
RITZ_INLINE void tangent_at(Index rows, Index r, Index points, const Scalar* gradients, const Scalar* A, Scalar* room,
                            Scalar* tangent) {
  const Index width = rows / lanes<Scalar>, depth = components_of_gradient * points;
  changes_at<Scalar>(width, points, packs(gradients), A, packs(room));
  const Pack<Scalar>* changes = packs(room);
  Pack<Scalar>* sums = packs(tangent);
  for (Index j = 0; j < r; j += block) {
    for (Index i = j / (2 * lanes<Scalar>)*2; i < width; i += 2) {
      Pack<Scalar> low[block], high[block];
      for (Index c = 0; c < block; ++c) low[c] = sums[(j + c) * width + i], high[c] = sums[(j + c) * width + i + 1];
      const Pack<Scalar>* change = changes + i;
      const Scalar* gradient = gradients + j;
      for (Index q = 0; q < depth; ++q, change += width, gradient += rows)
        for (Index c = 0; c < block; ++c) {
          low[c] += change[0] * gradient[c];
          high[c] += change[1] * gradient[c];
        }
      for (Index c = 0; c < block; ++c) sums[(j + c) * width + i] = low[c], sums[(j + c) * width + i + 1] = high[c];
    }
  }
}

}  // namespace

// One function for each scalar, because templates cannot be compiled for several machines.
RITZ_WIDE void displacement_gradients(Index rows, Index points, const double* gradients, const double* z, double* G) {
  gradients_at(rows, points, gradients, z, G);
}
RITZ_WIDE void displacement_gradients(Index rows, Index points, const float* gradients, const float* z, double* G) {
  gradients_at(rows, points, gradients, z, G);
}
RITZ_WIDE void add_force(Index rows, Index points, const double* gradients, const double* P, double* force) {
  force_at(rows, points, gradients, P, force);
}
RITZ_WIDE void add_force(Index rows, Index points, const float* gradients, const float* P, float* force) {
  force_at(rows, points, gradients, P, force);
}
RITZ_WIDE void add_tangent(Index rows, Index r, Index points, const double* gradients, const double* A, double* room,
                           double* tangent) {
  tangent_at(rows, r, points, gradients, A, room, tangent);
}
RITZ_WIDE void add_tangent(Index rows, Index r, Index points, const float* gradients, const float* A, float* room,
                           float* tangent) {
  tangent_at(rows, r, points, gradients, A, room, tangent);
}

}  // namespace ritz::runtime
