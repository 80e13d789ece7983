// Rayleigh-Ritz: the best eigenpairs in a subspace, and their residuals.
#pragma once
#include "ritz/algebra/multivector.hpp"

namespace ritz::stages {

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

}  // namespace ritz::stages
