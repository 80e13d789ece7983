// Internal forces of many bodies of one kind at once: the coefficients are read once for as many bodies as a vector
// register holds numbers.
#pragma once
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// The result of an evaluation for m bodies, and its work arrays; every thread needs its own.
template <class Scalar>
struct BatchEvaluation {
  Vector<Scalar> energy;    ///< Ẽ of each body, J, m numbers
  Matrix<Scalar> force;     ///< f̃ of each body, r x m
  Matrix<Scalar> tangents;  ///< K̃ of all bodies side by side, r x r m
  Matrix<Scalar> tangent;   ///< work array, as those below
  Vector<Scalar> sums;
  AlignedVector<Scalar> points, room, result;
};

/// Allocates the result of evaluate_batch for m = `instances` bodies.
template <class Scalar>
BatchEvaluation<Scalar> make_batch_evaluation(const PolynomialForce<Scalar>& forces, Eigen::Index instances);

/// Evaluates Ẽ, f̃ and K̃ at each column of z, r x m, with the m that `result` was made for. Does not allocate.
template <class Scalar>
void evaluate_batch(const PolynomialForce<Scalar>& forces,
                    const Eigen::Ref<const Matrix<std::type_identity_t<Scalar>>>& z, BatchEvaluation<Scalar>& result);

}  // namespace ritz::runtime
