// Factorizations of the dense r x r matrices of a step that is solved by Newton's method.
#pragma once
#include <Eigen/Cholesky>
#include <vector>

#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// The factorization of an r x r matrix: Cholesky's where `definite`, else LU with row pivoting.
template <class Scalar>
struct Factors {
  Eigen::LLT<Matrix<Scalar>> cholesky;
  Vector<Scalar> reciprocals;       ///< 1 / L_ii of Cholesky's factor, r
  Matrix<Scalar> lu;                ///< r x r: L below the diagonal (its own diagonal is 1), U on and above it
  std::vector<Eigen::Index> swaps;  ///< row k was exchanged with row swaps[k]; r numbers
  bool definite = true;             ///< which of the two factorizations is valid
};

/// Allocates the arrays for r x r matrices.
template <class Scalar>
Factors<Scalar> make_factors(Eigen::Index r);
/// Factors a symmetric matrix, r x r: by Cholesky's method, or by LU if it is not positive definite. Does not allocate.
template <class Scalar>
void factor(const Matrix<Scalar>& matrix, Factors<Scalar>& factors);
/// Factors any matrix, r x r, by LU. Does not detect a singular matrix. Does not allocate.
template <class Scalar>
void factor_unsymmetric(const Matrix<Scalar>& matrix, Factors<Scalar>& factors);
/// x := matrix⁻¹ x, r numbers. Does not allocate.
template <class Scalar>
void solve_in_place(const Factors<Scalar>& factors, Vector<Scalar>& x);

}  // namespace ritz::runtime
