// What solves with K: the factorization, or the multigrid cycle, that the modes were found with.
#pragma once
#include <functional>

#include "ritz/petsc/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// x ≈ (K − σM)⁻¹ b for all columns, σ ≤ 0 a shift below the spectrum; exact (σ = 0, a factorization) or a symmetric
/// positive definite preconditioner of K on what no rigid mode sees. Owns what it needs. *Collective*.
using Inverse = std::function<void(const petsc::ConstTallRef& b, petsc::TallRef x)>;

struct Solved {
  petsc::Tall x;
  int iterations = 0;
  double residual = 0;  ///< the largest ‖Kx − b‖ / ‖b‖ of a column
};

/// x = K⁻¹ b; where the body can move rigidly, K x = (I − M R Rᵀ) b with RᵀMx = 0, R the M-orthonormal `rigid` modes.
/// Conjugate gradients on all columns side by side, preconditioned with `inverse` (which, when exact, ends them at
/// once), until ‖Kx − b‖ ≤ max(1e-11 ‖b‖, 10 ε ‖K‖₁‖x‖). Throws NumericalError naming the residual. *Collective*.
Solved solve(const Matrices& matrices, const Inverse& inverse, const petsc::Tall& rigid, double norm_K,
             const petsc::ConstTallRef& b);

}  // namespace ritz::stages
