#include "kernels.hpp"

#include <algorithm>

// At one point coefficients are registers and coordinates numbers, in lanes it is the other way round: the same loops
// serve both.
namespace ritz::runtime {
namespace {

using Index = std::ptrdiff_t;

struct Assign {
  template <class Value>
  RITZ_INLINE static void to(Value& value, const Value& x) {
    value = x;
  }
};
struct Add {
  template <class Value>
  RITZ_INLINE static void to(Value& value, const Value& x) {
    value += x;
  }
};

/// Where row k of a half begins, less k: its column l is the l-th from there.
RITZ_INLINE Index row(Index r, Index k) { return k * (2 * r - k - 1) / 2; }

/// A register's coefficients, or one.
template <class Coefficient, class Scalar>
RITZ_INLINE const Coefficient& load(const Scalar* p) {
  return *reinterpret_cast<const Coefficient*>(p);
}

/// half = or += that of z_j Q_ij + z_{j+1} Q_i(j+1); returns where the next coefficients stand. `gradient` is room.
template <class Update, class Coefficient, class Scalar, class Coordinate>
RITZ_INLINE const Scalar* add_two_slices(Index r, Index j, const Scalar* c, const Coordinate* z, Pack<Scalar>* half,
                                         Pack<Scalar>* gradient) {
  constexpr Index width = lanes<Scalar>;
  using Value = Pack<Scalar>;
  const Value none{};
  const Value z0 = z[j] - none, z1 = z[j + 1] - none;
  Value *row0 = half + row(r, j), *row1 = half + row(r, j + 1);
  Value own{};
  for (Index l = j; l < r; ++l, c += width) {
    const Value p = load<Coefficient>(c) - none;
    gradient[2 * l] = p * z0;
    gradient[2 * l + 1] = none;
    Update::to(row0[l], p * z0);
    own += p * z[l];
  }
  row0[j] += gradient[2 * j] + own;
  for (Index k = j + 1; k < r; k += 2) {
    const Value zk = z[k] - none, next = z[k + 1] - none;
    const Value a = load<Coefficient>(c) - none, b = load<Coefficient>(c + width) - none;
    c += 2 * width;
    Value *to0 = half + row(r, k), *to1 = half + row(r, k + 1);
    Update::to(to0[k], a * z0 + b * z1);
    Value a0 = a * zk, b0 = b * zk, a1{}, b1{};
    for (Index l = k + 1; l < r; ++l, c += 4 * width) {
      const Value p = load<Coefficient>(c) - none, q = load<Coefficient>(c + width) - none;
      const Value s = load<Coefficient>(c + 2 * width) - none, t = load<Coefficient>(c + 3 * width) - none;
      const Value zl = z[l] - none;
      Update::to(to0[l], p * z0 + q * z1);
      Update::to(to1[l], s * z0 + t * z1);
      a0 += p * zl, b0 += q * zl, a1 += s * zl, b1 += t * zl;
      gradient[2 * l] += p * zk + s * next;
      gradient[2 * l + 1] += q * zk + t * next;
    }
    row0[k] += gradient[2 * k] + (a * zk + a0);
    row1[k] += gradient[2 * k + 1] + (b * zk + b0);
    if (k + 1 == r) break;
    row0[k + 1] += gradient[2 * k + 2] + a1;
    row1[k + 1] += gradient[2 * k + 3] + b1;
  }
  return c;
}

/// half += z_i ∇²(Q_i + P_i) from row `begin` on, and force += z_i ∇(Q_i + P_i), where `slice` is the half of ∇²P_i;
/// leaves ∇(Q_i + P_i) at the front of `gradient`, and Q_i + P_i in `value`. `c` stands at row `begin`.
template <class Coefficient, class Scalar, class Coordinate>
RITZ_INLINE void add_slice(Index r, Index begin, const Pack<Scalar>& zi, const Scalar* c, const Coordinate* z,
                           const Pack<Scalar>* slice, Pack<Scalar>* gradient, Pack<Scalar>* half, Pack<Scalar>* force,
                           Pack<Scalar>& value) {
  using Value = Pack<Scalar>;
  const Value none{};
  Value cubic{}, quartic{};
  for (Index l = begin; l < r; ++l) gradient[2 * l] = gradient[2 * l + 1] = none;
  for (Index k = begin; k < r; ++k) {
    const Value zk = z[k] - none;
    const Value* from = slice + row(r, k);
    Value *to = half + row(r, k), own3{}, own4{};
    for (Index l = k; l < r; ++l, c += lanes<Scalar>) {
      const Value p = load<Coefficient>(c) - none, q = from[l], zl = z[l] - none;
      to[l] += (p + q) * zi;
      own3 += p * zl, own4 += q * zl;
      gradient[2 * l] += p * zk;
      gradient[2 * l + 1] += q * zk;
    }
    const Value slope3 = gradient[2 * k] + own3, slope4 = (gradient[2 * k + 1] + own4) * Scalar(0.5);
    gradient[k] = slope3 + slope4;
    force[k] += gradient[k] * zi;
    cubic += slope3 * zk;
    quartic += slope4 * zk;
  }
  value = cubic * Scalar(0.5) + quartic * Scalar(1.0 / 3);
}

template <class Scalar>
RITZ_INLINE void at_point(Index r, const Scalar* cubic, const Scalar* quartic, const Scalar* z, Scalar* room,
                          Scalar* result) {
  using Value = Pack<Scalar>;
  constexpr Index width = lanes<Scalar>;
  const Index pairs = r * (r + 1) / 2;
  Value *slice = packs(room), *gradient = slice + pairs, *half = packs(result), *force = half + pairs;
  std::fill(half, half + result_size(r), Value{});
  for (Index i0 = 0; i0 < r; i0 += width) {
    quartic = add_two_slices<Assign, Value>(r, i0, quartic, z, slice, gradient);
    for (Index j = i0 + 2; j < r; j += 2) quartic = add_two_slices<Add, Value>(r, j, quartic, z, slice, gradient);
    const Value& zi = *packs(z + i0);
    Value value;
    add_slice<Value>(r, i0, zi, cubic, z, slice, gradient, half, force, value);
    cubic += (pairs - row(r, i0) - i0) * width;
    force[r] += value * zi;
    for (Index e = 0, i = i0; e < width && i < r; ++e, ++i) {
      force[i][e] += value[e];
      for (Index l = i; l < r; ++l) half[row(r, i) + l][e] += gradient[l][e];
    }
  }
}

template <class Scalar>
RITZ_INLINE void in_lanes(Index r, const Scalar* cubic, const Scalar* quartic, const Scalar* points, Scalar* room,
                          Scalar* result) {
  using Value = Pack<Scalar>;
  constexpr Index width = lanes<Scalar>;
  const Index pairs = r * (r + 1) / 2;
  const Value* z = packs(points);
  Value *slices = packs(room), *gradient = slices + pairs * width, *half = packs(result), *force = half + pairs;
  std::fill(half, half + result_size(r), Value{});
  for (Index i0 = 0; i0 < r; i0 += width) {
    const Index count = std::min(width, r - i0);
    for (Index j = i0; j < r; j += 2) {
      const Scalar* next = quartic;
      for (Index e = 0; e < std::min(count, j - i0 + 2); ++e) {
        Value* slice = slices + e * pairs;
        next = j - i0 < e / 2 * 2 + 2 ? add_two_slices<Assign, Scalar>(r, j, quartic + e, z, slice, gradient)
                                      : add_two_slices<Add, Scalar>(r, j, quartic + e, z, slice, gradient);
        next -= e;
      }
      quartic = next;
    }
    for (Index e = 0; e < count; ++e) {
      const Index i = i0 + e, begin = i0 + e / 2 * 2;  // the pair of slices that holds i
      const Scalar* c = cubic + (row(r, begin) + begin - row(r, i0) - i0) * width + e;
      Value value;
      add_slice<Scalar>(r, begin, z[i], c, z, slices + e * pairs, gradient, half, force, value);
      force[r] += value * z[i];
      force[i] += value;
      for (Index l = i; l < r; ++l) half[row(r, i) + l] += gradient[l];
    }
    cubic += (pairs - row(r, i0) - i0) * width;
  }
}

}  // namespace

#define RITZ_INSTANCE(S)                                                                                             \
  RITZ_WIDE void differentiate_at_point(Index r, const S* cubic, const S* quartic, const S* z, S* room, S* result) { \
    at_point(r, cubic, quartic, z, room, result);                                                                    \
  }                                                                                                                  \
  RITZ_WIDE void differentiate_in_lanes(Index r, const S* cubic, const S* quartic, const S* z, S* room, S* result) { \
    in_lanes(r, cubic, quartic, z, room, result);                                                                    \
  }
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
