// Solves with K, by the factorization or the multigrid cycle with which the modes were found.
#pragma once
#include <functional>

#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// *Collective*. x ≈ (K − σM)⁻¹ b for all columns, with a shift σ ≤ 0 below the spectrum: exact for a factorization
/// with σ = 0, otherwise a symmetric positive definite preconditioner for K on the complement of the rigid modes. The
/// function owns what it needs.
using Inverse = std::function<void(const algebra::ConstTallRef& b, algebra::TallRef x)>;

struct Solved {
  algebra::Tall x;
  int iterations = 0;
  double residual = 0;  ///< the largest ‖Kx − b‖ / ‖b‖ of all columns
};

/// *Collective*. x = K⁻¹ b; if the body can move rigidly, K x = (I − M R Rᵀ) b with RᵀMx = 0, where R are the
/// M-orthonormal `rigid` modes. Conjugate gradients on all columns at once, preconditioned with `inverse` (an exact one
/// ends them in one iteration), until ‖Kx − b‖ ≤ max(tolerance ‖b‖, 10 ε ‖K‖₁‖x‖). Throws a NumericalError that names
/// the residual.
Solved solve(const Matrices& matrices, const Inverse& inverse, const algebra::Tall& rigid, double norm_K,
             const algebra::ConstTallRef& b, double tolerance = 1e-11);

}  // namespace ritz::stages
