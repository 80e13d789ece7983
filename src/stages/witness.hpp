// A reduced model's own witness: what it claims, computed another way.
#pragma once
#include "ritz/model/model.hpp"
#include "ritz/stages/derivatives.hpp"

namespace ritz::stages {

/// The largest relative errors of a polynomial against the full model.
struct PolynomialErrors {
  double force = 0;      ///< f̃(z) against Uᵀf(Uz)
  double energy = 0;     ///< Ẽ(z) against E(Uz)
  double stiffness = 0;  ///< K̃(0) against UᵀKU
};

/// Compares the polynomial with the full model at random z whose largest displacements are 1e-6 ... 1e2 times a tenth
/// of the body's size (nine decades). `u`: the basis over owned vertices. Throws NumericalError that says which of the
/// errors is above 1e-11 and above what rounding of K u alone explains. *Collective*.
PolynomialErrors polynomial_witness(const Problem& problem, mesh::VertexRef u, const model::Polynomial& polynomial);

/// The power of t with which ‖f(t ψ + t² φ) − t K ψ‖ falls over six halvings of t, without resultants where the body is
/// free: 3 where φ = ½ Σ p_i p_j Φ_ij belongs to ψ = Σ p_i ψ_i (Eq. 17), and 2 for any other φ, zero included. The t
/// are the smallest of those tried at which rounding does not hide the remainder; NaN where there are not enough.
/// `line`: ψ, `curve`: φ, a column each. *Collective*.
double taylor_slope(const DerivativesSource& source, mesh::FreeRef line, mesh::FreeRef curve);

/// Throws NumericalError for a slope outside [2.9, 3.1], and for one that is not a number.
void require_third_order(double slope);

/// That slope along a direction in the first (at most three) modes, whose derivatives it solves for again. Throws as
/// above. *Collective*.
double taylor_witness(const DerivativesSource& source);

}  // namespace ritz::stages
