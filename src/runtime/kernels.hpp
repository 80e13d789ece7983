// The cubic and the quartic energy with two derivatives, in one pass over the coefficients, by Horner's rule:
//
//   E3 = Σ_i z_i Q_i(z),  E4 = Σ_i z_i P_i(z),  P_i = Σ_{j≥i} z_j Q_ij(z),  Q_ij = Σ_{j≤k≤l} c_ijkl z_k z_l,
//
// with c_ijkl = C_ijkl over the factorials of how often an index repeats. A sum Σ_j z_j Q_j adds to a Hessian
// z_j ∇²Q_j + e_j ∇Q_jᵀ + ∇Q_j e_jᵀ, and ∇Q = ∇²Q z, ∇P = ½ ∇²P z: three products for each coefficient. A Hessian is
// kept as its half V, V + Vᵀ = ∇², whose rows k hold the columns l ≥ k one after the other.
//
// Coefficients stand in the order in which they are used. A register holds those of as many i as it has numbers, from
// i0 on; where i is too large for the other indices it holds 0.
//   cubic: for each i0, for k ≥ i0, for l ≥ k, c_ikl.
//   quartic: for each i0, for j = i0, i0 + 2, ...: c_ijjl for l ≥ j; then for k = j + 1, j + 3, ...: c_ijkk,
//   c_i(j+1)kk, and for l > k: c_ijkl, c_i(j+1)kl, c_ij(k+1)l, c_i(j+1)(k+1)l.
#pragma once
#include <cstddef>

#include "simd.hpp"

namespace ritz::runtime {

/// Registers that a pass over r coordinates returns: the half of H3 + H4, their force, their energy.
constexpr std::ptrdiff_t result_size(std::ptrdiff_t r) { return r * (r + 1) / 2 + r + 1; }

/// Registers that it needs as room.
constexpr std::ptrdiff_t room_at_point(std::ptrdiff_t r) { return r * (r + 1) / 2 + 2 * r; }
template <class Scalar>
constexpr std::ptrdiff_t room_in_lanes(std::ptrdiff_t r) {
  return r * (r + 1) / 2 * lanes<Scalar> + 2 * r;
}

/// At z, which goes on with zeros to the end of its last register and one more: what a register of the result sums up
/// to is a number of it.
void differentiate_at_point(std::ptrdiff_t r, const double* cubic, const double* quartic, const double* z, double* room,
                            double* result);
void differentiate_at_point(std::ptrdiff_t r, const float* cubic, const float* quartic, const float* z, float* room,
                            float* result);

/// At as many points as a register has numbers: one of each, in z and in the result. A register of zeros follows z.
void differentiate_in_lanes(std::ptrdiff_t r, const double* cubic, const double* quartic, const double* z, double* room,
                            double* result);
void differentiate_in_lanes(std::ptrdiff_t r, const float* cubic, const float* quartic, const float* z, float* room,
                            float* result);

}  // namespace ritz::runtime
