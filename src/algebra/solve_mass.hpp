// Solves with a mass matrix, without a factorization.
#pragma once
#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

/// *Collective*. x = A⁻¹ b for a well-conditioned positive definite A, such as a mass matrix, by CG with its diagonal
/// as preconditioner, to rounding errors. Throws NumericalError when it does not converge.
Tall solve_mass(Mat A, const ConstTallRef& b);

}  // namespace ritz::algebra
