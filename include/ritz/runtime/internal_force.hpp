// The internal force f̃(z) of a reduced model: of small displacements, or a polynomial; of a body at rest or of one that
// a frame carries. A new kind is one struct with size() and the functions below, and one alternative of the variant.
#pragma once
#include <array>
#include <variant>

#include "ritz/runtime/frame.hpp"
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// f̃(z) = Λz with a diagonal Λ: the force of small displacements over a basis that diagonalises UᵀKU (Eq. 3).
template <class Scalar>
struct LinearForce {
  Vector<Scalar> stiffness;  ///< λ, r, rad²/s²; exactly 0 for a rigid mode

  Eigen::Index size() const { return stiffness.size(); }
};

template <class Scalar>
Evaluation<Scalar> make_evaluation(const LinearForce<Scalar>& force);
template <class Scalar>
void evaluate(const LinearForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);

/// The force of a body that a rigid frame carries, by the 6 + r coordinates of the frame's motion and of z: moving the
/// frame deforms nothing, so that its first six components are 0.
template <class Scalar>
struct CarriedForce {
  std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>> body;

  Eigen::Index size() const {
    return frame_coordinates + std::visit([](const auto& force) { return force.size(); }, body);
  }
};

template <class Scalar>
Evaluation<Scalar> make_evaluation(const CarriedForce<Scalar>& force);
template <class Scalar>
void evaluate(const CarriedForce<Scalar>& force, const VectorRef<Scalar>& q, Evaluation<Scalar>& result);

template <class Scalar>
using InternalForce = std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>, CarriedForce<Scalar>>;

template <class Scalar>
Eigen::Index size(const InternalForce<Scalar>& force) {
  return std::visit([](const auto& f) { return f.size(); }, force);
}

template <class Scalar>
Evaluation<Scalar> make_evaluation(const InternalForce<Scalar>& force) {
  return std::visit([](const auto& f) { return make_evaluation(f); }, force);
}

/// Ẽ, f̃ and K̃ at z. Does not allocate. What is not finite in z is not finite in the result.
template <class Scalar>
void evaluate(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result) {
  std::visit([&](const auto& f) { evaluate<Scalar>(f, z, result); }, force);
}

/// K̃(0), r x r.
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const InternalForce<Scalar>& force);

/// The mean over a straight step, and room for it.
template <class Scalar>
struct MeanEvaluation {
  Vector<Scalar> force;    ///< ∫₀¹ f̃(z + s d) ds, r
  Matrix<Scalar> tangent;  ///< its derivative by d, ∫₀¹ s K̃(z + s d) ds, r x r
  Vector<Scalar> point;
  Evaluation<Scalar> at_point;
};

template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const InternalForce<Scalar>& force);

/// ∫₀¹ f̃(z + s d) ds and its derivative by d, for which two Gauss points are exact as f̃ is cubic at most: with
/// s = ½ ∓ 1/√12, the force is the mean of f̃(z + s d), the tangent the mean of s K̃(z + s d). Hence
/// force · d = Ẽ(z + d) − Ẽ(z). Does not allocate.
template <class Scalar>
void evaluate_mean(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result);

/// The two points s of a step at which the mean is taken.
template <class Scalar>
std::array<Scalar, 2> mean_points();

}  // namespace ritz::runtime
