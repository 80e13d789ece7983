// The r x r systems of a nonlinear step.
#pragma once
#include <Eigen/Cholesky>
#include <vector>

#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// A matrix, factored by Cholesky's method or by pivoted LU.
template <class Scalar>
struct Factors {
  Eigen::LLT<Matrix<Scalar>> cholesky;
  Vector<Scalar> reciprocals;       ///< of Cholesky's pivots
  Matrix<Scalar> lu;                ///< L below the diagonal, U on and above it
  std::vector<Eigen::Index> swaps;  ///< the row that was exchanged with each
  bool definite = true;
};

template <class Scalar>
Factors<Scalar> make_factors(Eigen::Index r);
/// Of a symmetric matrix, by LU where Cholesky's method fails. Does not allocate.
template <class Scalar>
void factor(const Matrix<Scalar>& matrix, Factors<Scalar>& factors);
/// Of any matrix. Does not allocate.
template <class Scalar>
void factor_unsymmetric(const Matrix<Scalar>& matrix, Factors<Scalar>& factors);
/// x := matrix⁻¹ x. Does not allocate.
template <class Scalar>
void solve_in_place(const Factors<Scalar>& factors, Vector<Scalar>& x);

}  // namespace ritz::runtime
