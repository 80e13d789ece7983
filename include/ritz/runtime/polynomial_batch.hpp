// The forces of many bodies of one kind at once: the coefficients are read once for a register's width of bodies.
#pragma once
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// What an evaluation of m instances returns, and room for it; one a thread.
template <class Scalar>
struct BatchEvaluation {
  Vector<Scalar> energy;    ///< Ẽ of each, m
  Matrix<Scalar> force;     ///< f̃ of each, r x m
  Matrix<Scalar> tangents;  ///< K̃ of each, r x r m, side by side
  Matrix<Scalar> tangent;
  Vector<Scalar> sums;
  AlignedVector<Scalar> points, room, result;
};

template <class Scalar>
BatchEvaluation<Scalar> make_batch_evaluation(const PolynomialForce<Scalar>& forces, Eigen::Index instances);

/// Ẽ, f̃ and K̃ at each column of z (r x m, m as the result was made for). Does not allocate.
template <class Scalar>
void evaluate_batch(const PolynomialForce<Scalar>& forces,
                    const Eigen::Ref<const Matrix<std::type_identity_t<Scalar>>>& z, BatchEvaluation<Scalar>& result);

}  // namespace ritz::runtime
