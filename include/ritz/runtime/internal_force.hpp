// The internal force f̃(z) of a reduced model: linear (small displacements), polynomial or a cubature; of a body at rest
// or of one that a rigid frame carries. A new kind is one struct with size(), make_evaluation, evaluate and
// stiffness_at_rest, and one alternative of InternalForce.
#pragma once
#include <span>
#include <variant>

#include "ritz/runtime/cubature_force.hpp"
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

/// The internal force of a body that nothing carries.
template <class Scalar>
using BodyForce = std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>, CubatureForce<Scalar>>;

/// The internal force of a body that a rigid frame carries, over the 6 + r coordinates of the frame's motion and of z
/// (frame.hpp). Moving the frame deforms nothing, so that the first six components are 0.
template <class Scalar>
struct CarriedForce {
  BodyForce<Scalar> body;

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
using InternalForce =
    std::variant<LinearForce<Scalar>, PolynomialForce<Scalar>, CubatureForce<Scalar>, CarriedForce<Scalar>>;

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

/// Computes ∫₀¹ f̃(z + s d) ds and its derivative with respect to d by the Gauss points of mean_rule: the force is the
/// mean of f̃(z + s d) over them, the tangent that of s K̃(z + s d). z and d have r entries. Does not allocate.
template <class Scalar>
void evaluate_mean(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result);

/// A Gauss point 0 < s < 1 of a mean, and its weight; weights add up to 1.
template <class Scalar>
struct MeanPoint {
  Scalar s, weight;
};

/// Whether f̃ is a polynomial in z, at most a cubic one.
template <class Scalar>
bool is_cubic(const InternalForce<Scalar>& force);

/// Whether the internal force is defined at z: laws of a cubature do not admit every state (fem::Response), and all
/// other forces do. Overwrites the work arrays of `room`.
template <class Scalar>
bool admits(const InternalForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& room);

/// The points of evaluate_mean, ascending. Two are exact for a force that is at most cubic, so that force · d =
/// Ẽ(z + d) − Ẽ(z). For others there are four, exact to degree 7: over a step that resolves the motion, energies then
/// agree to rounding.
template <class Scalar>
std::span<const MeanPoint<Scalar>> mean_rule(const InternalForce<Scalar>& force);

}  // namespace ritz::runtime
