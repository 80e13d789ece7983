// The internal force f̃(z) of a reduced model: linear (small displacements) or polynomial; of a body at rest or of one
// that a rigid frame carries. A new kind is one struct with size(), make_evaluation, evaluate and stiffness_at_rest,
// and one alternative of InternalForce.
#pragma once
#include <array>
#include <variant>

#include "ritz/runtime/frame.hpp"
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// f̃(z) = Λz with Λ diagonal: the internal force of small displacements, over a basis that diagonalises UᵀKU (Eq. 3 of
/// the notes).
template <class Scalar>
struct LinearForce {
  Vector<Scalar> stiffness;  ///< λ, r numbers, 1/s²; exactly 0 for a rigid mode

  Eigen::Index size() const { return stiffness.size(); }
};

/// Allocates the result of evaluate, and sets its tangent, which is constant.
template <class Scalar>
Evaluation<Scalar> make_evaluation(const LinearForce<Scalar>& force);
/// As evaluate of an InternalForce below.
template <class Scalar>
void evaluate(const LinearForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);
/// K̃(0).
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const LinearForce<Scalar>& force);
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const PolynomialForce<Scalar>& force);

/// The internal force of a body that a rigid frame carries, over the 6 + r coordinates of the frame's motion and of z
/// (frame.hpp). Moving the frame deforms nothing, so that the first six components are 0.
template <class Scalar>
struct CarriedForce {
  std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>> body;

  Eigen::Index size() const {
    return frame_coordinates + std::visit([](const auto& force) { return force.size(); }, body);
  }
};

/// Allocates the result of evaluate.
template <class Scalar>
Evaluation<Scalar> make_evaluation(const CarriedForce<Scalar>& force);
/// As evaluate of an InternalForce; `q` and the results have 6 + r coordinates.
template <class Scalar>
void evaluate(const CarriedForce<Scalar>& force, const VectorRef<Scalar>& q, Evaluation<Scalar>& result);
/// K̃(0).
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const CarriedForce<Scalar>& force);

/// The internal force of a model, of any kind.
template <class Scalar>
using InternalForce = std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>, CarriedForce<Scalar>>;

/// The number of coordinates: r, or 6 + r of a carried body.
template <class Scalar>
Eigen::Index size(const InternalForce<Scalar>& force) {
  return std::visit([](const auto& f) { return f.size(); }, force);
}

/// Allocates the result of evaluate.
template <class Scalar>
Evaluation<Scalar> make_evaluation(const InternalForce<Scalar>& force) {
  return std::visit([](const auto& f) { return make_evaluation(f); }, force);
}

/// Writes the energy Ẽ, the force f̃ and the tangent K̃ = df̃/dz at z, r numbers, to `result`. Does not allocate. Where
/// z is not finite, Ẽ and f̃ are not finite either.
template <class Scalar>
void evaluate(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result) {
  std::visit([&](const auto& f) { evaluate<Scalar>(f, z, result); }, force);
}

/// K̃(0), r x r, 1/s².
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const InternalForce<Scalar>& force) {
  return std::visit([](const auto& f) { return stiffness_at_rest(f); }, force);
}

/// The mean of the internal force over the straight line from z to z + d, and its work arrays.
template <class Scalar>
struct MeanEvaluation {
  Vector<Scalar> force;         ///< ∫₀¹ f̃(z + s d) ds, r
  Matrix<Scalar> tangent;       ///< its derivative with respect to d, ∫₀¹ s K̃(z + s d) ds, r x r
  Vector<Scalar> point;         ///< work array, r
  Evaluation<Scalar> at_point;  ///< at the Gauss point that was evaluated last
};

/// Allocates the result of evaluate_mean.
template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const InternalForce<Scalar>& force);

/// Computes ∫₀¹ f̃(z + s d) ds and its derivative with respect to d; z and d have r entries. Two Gauss points
/// s = ½ ∓ 1/√12 are exact, as f̃ is at most cubic: the force is the mean of f̃(z + s d) over the two points, the tangent
/// the mean of s K̃(z + s d). Hence force · d = Ẽ(z + d) − Ẽ(z). Does not allocate.
template <class Scalar>
void evaluate_mean(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result);

/// The two Gauss points s = ½ ∓ 1/√12 of evaluate_mean, ascending.
template <class Scalar>
std::array<Scalar, 2> mean_points();

}  // namespace ritz::runtime
