// Operations on whole sparse matrices. All are *Collective*.
#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "ritz/algebra/handle.hpp"
#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

/// The number of rows, over all ranks.
std::int64_t rows(const Matrix& A);
/// The entries A_ii of this rank's rows.
Eigen::VectorXd diagonal(Mat A);
/// max_i Σ_j |A_ij|, which for a symmetric matrix is ‖A‖₁ and a bound of ‖A‖₂.
double one_norm(const Matrix& A);

/// Where B may have entries: at the same places as A, or at some of them.
enum class Pattern { same, subset };

/// A += factor B.
void add(const Matrix& A, double factor, const Matrix& B, Pattern pattern);
Matrix copy(const Matrix& A);

/// *Collective*. x = A⁻¹ b for a well-conditioned positive definite A, such as a mass matrix, by CG with its diagonal
/// as preconditioner, to rounding errors. Throws NumericalError when it does not converge.
Tall solve_mass(Mat A, const ConstTallRef& b);

}  // namespace ritz::algebra
