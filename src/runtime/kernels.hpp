// Kernels for the cubic and the quartic energy with their first and second derivatives, in one pass over the
// coefficients, by Horner's rule:
//
//   E3 = Σ_i z_i Q_i(z),  E4 = Σ_i z_i P_i(z),  P_i = Σ_{j≥i} z_j Q_ij(z),  Q_ij = Σ_{j≤k≤l} c_ijkl z_k z_l,
//
// where c_ijkl is C_ijkl divided by the factorials of the numbers of times that an index repeats. A sum Σ_j z_j Q_j
// adds z_j ∇²Q_j + e_j ∇Q_jᵀ + ∇Q_j e_jᵀ to a Hessian, and ∇Q = ∇²Q z, ∇P = ½ ∇²P z: three products for each
// coefficient. A Hessian is stored as the half V with V + Vᵀ = ∇², whose rows k hold the columns l ≥ k, one row after
// the other.
//
// Coefficients are stored in the order in which they are used. One register holds the coefficients of several
// consecutive indices i, beginning at i0; entries in which i exceeds the other indices are 0.
//   cubic: for each i0, for k ≥ i0, for l ≥ k, c_ikl.
//   quartic: for each i0, for j = i0, i0 + 2, ...: c_ijjl for l ≥ j; then for k = j + 1, j + 3, ...: c_ijkk,
//   c_i(j+1)kk, and for l > k: c_ijkl, c_i(j+1)kl, c_ij(k+1)l, c_i(j+1)(k+1)l.
#pragma once
#include <cstddef>

#include "ritz/base/simd.hpp"

namespace ritz::runtime {

/// The number of registers that a pass over r coordinates returns: half of H3 + H4, the force of both, their energy.
constexpr std::ptrdiff_t result_size(std::ptrdiff_t r) { return r * (r + 1) / 2 + r + 1; }

/// The number of registers that it needs as work space.
constexpr std::ptrdiff_t room_at_point(std::ptrdiff_t r) { return r * (r + 1) / 2 + 2 * r; }
template <class Scalar>
constexpr std::ptrdiff_t room_in_lanes(std::ptrdiff_t r) {
  return r * (r + 1) / 2 * lanes<Scalar> + 2 * r;
}

/// Evaluates at one point z. z is padded with zeros to the end of its last register, and by one more register. Each
/// register of `result` holds partial sums: adding up its numbers gives one number of the result.
void differentiate_at_point(std::ptrdiff_t r, const double* cubic, const double* quartic, const double* z, double* room,
                            double* result);
void differentiate_at_point(std::ptrdiff_t r, const float* cubic, const float* quartic, const float* z, float* room,
                            float* result);

/// Evaluates at several points at once, as many as a register holds numbers: entry p of each register of z and of
/// `result` belongs to point p. A register of zeros follows z.
void differentiate_in_lanes(std::ptrdiff_t r, const double* cubic, const double* quartic, const double* z, double* room,
                            double* result);
void differentiate_in_lanes(std::ptrdiff_t r, const float* cubic, const float* quartic, const float* z, float* room,
                            float* result);

}  // namespace ritz::runtime
