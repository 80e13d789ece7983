// The witnesses of a reduced model: its results, computed in a second way (docs/glossary.md).
#pragma once
#include "ritz/model/model.hpp"
#include "ritz/stages/derivatives.hpp"

namespace ritz::stages {

/// The largest relative differences between a polynomial and the full model, with St. Venant-Kirchhoff materials of the
/// same constants at rest in place of those whose forces are no polynomials.
struct PolynomialErrors {
  double force = 0;      ///< f̃(z) and Uᵀf(Uz)
  double energy = 0;     ///< Ẽ(z) and E(Uz)
  double stiffness = 0;  ///< K̃(0) and UᵀKU
};

/// *Collective*. Compares the polynomial with the full model at random z whose largest displacements are 1e-6 ... 1e2
/// times a tenth of the body's size (nine decades). `u` is the basis over owned vertices, 3 rows for each. Throws a
/// NumericalError that names the error that is above 1e-11 and above what rounding errors of K u explain.
PolynomialErrors polynomial_witness(const Problem& problem, mesh::VertexRef u, const model::Polynomial& polynomial);

/// *Collective*. The Taylor slope: the power of t with which ‖f(t ψ + t² φ) − t K ψ‖ decreases over six halvings of t;
/// for a free body without the resultants of f. It is 3 if φ = ½ Σ p_i p_j Φ_ij belongs to ψ = Σ p_i ψ_i (Eq. 17 of the
/// notes), and 2 for any other φ, including zero. The t are the smallest of those tried at which rounding errors do not
/// hide the remainder; NaN if there are not enough. `line` is ψ and `curve` is φ, one column each.
double taylor_slope(const DerivativesSource& source, mesh::FreeRef line, mesh::FreeRef curve);

/// Throws NumericalError for a slope outside [2.9, 3.1] and for NaN.
void require_third_order(double slope);

/// *Collective*. The Taylor slope along a direction in the first (at most three) modes, whose derivatives are solved
/// for again. Throws NumericalError as require_third_order does.
double taylor_witness(const DerivativesSource& source);

}  // namespace ritz::stages
