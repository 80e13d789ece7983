// Rayleigh-Ritz: the best eigenpairs that a subspace holds, and how good they are.
#pragma once
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

struct RitzPairs {
  Eigen::VectorXd values;  ///< λ ascending
  petsc::Tall vectors;     ///< M-orthonormal
};

/// Diagonalises K over span(x), first M-orthonormalising x against the M-orthonormal `against`; columns that depend on
/// others are dropped. *Collective*.
RitzPairs rayleigh_ritz(Mat K, Mat M, const petsc::ConstTallRef& against, petsc::Tall x);

struct Residuals {
  Eigen::VectorXd relative;  ///< ‖Kψ − λMψ‖ / (λ‖Mψ‖)
  Eigen::VectorXd gate;      ///< max(1e-8, 10 ε‖K‖‖ψ‖ / (λ‖Mψ‖)), which `relative` has to meet
  petsc::Tall vectors;       ///< Kψ − λMψ
};

/// `norm_K` is ‖K‖₁. *Collective*.
Residuals residuals(Mat K, Mat M, double norm_K, const RitzPairs& pairs);

inline constexpr double residual_gate = 1e-8;
inline constexpr double orthonormality_gate = 1e-12;  ///< max |XᵀMX − I| of modes and of a basis

/// ‖A‖₁ = ‖A‖∞ of a symmetric matrix. *Collective*.
double one_norm(Mat A);

}  // namespace ritz::stages
