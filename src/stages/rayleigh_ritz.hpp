// Rayleigh-Ritz: the best eigenpairs in a subspace, and their residuals; and with it the order of magnitude of a body's
// lowest frequency, before anything is solved.
#pragma once
#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// The columns of a, then those of b.
algebra::Tall side_by_side(const algebra::ConstTallRef& a, const algebra::ConstTallRef& b);

struct RitzPairs {
  Eigen::VectorXd values;  ///< λ ascending
  algebra::Tall vectors;   ///< M-orthonormal
};

/// *Collective*. Diagonalises K over span(x), after M-orthonormalising x against the M-orthonormal columns `against`;
/// columns that depend linearly on others are dropped.
RitzPairs rayleigh_ritz(const algebra::Matrix& K, const algebra::Matrix& M, const algebra::ConstTallRef& against,
                        algebra::Tall x);

struct Residuals {
  Eigen::VectorXd relative;  ///< ‖Kψ − λMψ‖ / (λ‖Mψ‖)
  Eigen::VectorXd gate;      ///< max(1e-8, 10 ε‖K‖‖ψ‖ / (λ‖Mψ‖)), the bound that `relative` has to meet
  algebra::Tall vectors;     ///< Kψ − λMψ
};

/// *Collective*. The residuals of the pairs. `norm_K` is ‖K‖₁.
Residuals residuals(const algebra::Matrix& K, const algebra::Matrix& M, double norm_K, const RitzPairs& pairs);

inline constexpr double residual_gate = 1e-8;  ///< bound of a relative residual ‖Kψ − λMψ‖ / (λ‖Mψ‖)
inline constexpr double orthonormality_gate = 1e-12;  ///< bound of max |XᵀMX − I| for modes and for a basis

/// *Collective*. An upper bound on the lowest elastic eigenvalue λ, rad²/s²: Rayleigh-Ritz over displacement fields
/// that are cubic in the coordinates, orthogonal to the rigid motions `rigid` (M-orthonormal).
double elastic_scale(const Problem& problem, mesh::FreeRef rigid);

}  // namespace ritz::stages
