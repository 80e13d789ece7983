// Solves that need no factorization.
#pragma once
#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

/// x = A⁻¹ b for a well-conditioned positive definite A, such as a mass matrix: CG with its diagonal, to rounding.
/// Throws NumericalError. *Collective*.
Tall solve_mass(Mat A, const ConstTallRef& b);

}  // namespace ritz::petsc
