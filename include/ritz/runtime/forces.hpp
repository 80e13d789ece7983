// Energy, force and tangent of the reduced StVK polynomial (model::Polynomial), all from one pass:
//
//   H3_ij = B_ijk z_k,  H4_ij = ½ C_ijkl z_k z_l,
//   Ẽ = (A + H3/3 + H4/6) : zzᵀ / 2,  f̃ = dẼ/dz = (A + H3/2 + H4/3) z,  K̃ = df̃/dz = A + H3 + H4.
//
// The tangent's two matrices follow from the unique coefficients i ≤ j ≤ k ≤ l alone, three products for each; force
// and energy cost next to nothing then. The coefficients are laid out for that pass, a register's width at a time.
#pragma once
#include <Eigen/Core>
#include <type_traits>

#include "ritz/base/aligned.hpp"
#include "ritz/model/model.hpp"

namespace ritz::runtime {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using VectorRef = Eigen::Ref<const Vector<std::type_identity_t<Scalar>>>;

/// The coefficients, laid out; constant while they are used, by any number of threads.
template <class Scalar>
struct Forces {
  Eigen::Index r = 0;
  Matrix<Scalar> linear;                 ///< A = K̃(0), r x r
  AlignedVector<Scalar> cubic, quartic;  ///< B and C in the order of src/runtime/kernels.hpp
};

/// Lays the polynomial out, in double or float. Throws InputError when its arrays do not have the sizes that r says.
template <class Scalar>
Forces<Scalar> make_forces(const model::Polynomial& polynomial);

/// What one evaluation returns, and room for it; one a thread.
template <class Scalar>
struct Evaluation {
  Scalar energy = 0;       ///< Ẽ, J
  Vector<Scalar> force;    ///< f̃, r
  Matrix<Scalar> tangent;  ///< K̃, r x r, both triangles
  Vector<Scalar> sums;
  AlignedVector<Scalar> point, room, result;
};

template <class Scalar>
Evaluation<Scalar> make_evaluation(const Forces<Scalar>& forces);

/// Ẽ, f̃ and K̃ at z. Does not allocate. What is not finite in z is not finite in the result.
template <class Scalar>
void evaluate(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);

/// Room for an evaluation along a straight step.
template <class Scalar>
struct MeanEvaluation {
  Vector<Scalar> force;    ///< the mean of f̃ over the step, r
  Matrix<Scalar> tangent;  ///< its derivative with respect to the step, r x r
  Vector<Scalar> point;
  Evaluation<Scalar> at_point;
};

template <class Scalar>
MeanEvaluation<Scalar> make_mean_evaluation(const Forces<Scalar>& forces);

/// ∫₀¹ f̃(z + s d) ds and its derivative by d, for which two Gauss points are exact as f̃ is cubic: with
/// s = ½ ∓ 1/√12, the force is the mean of f̃(z + s d), the tangent the mean of s K̃(z + s d). Hence
/// force · d = Ẽ(z + d) − Ẽ(z). Does not allocate.
template <class Scalar>
void evaluate_mean(const Forces<Scalar>& forces, const VectorRef<Scalar>& z, const VectorRef<Scalar>& d,
                   MeanEvaluation<Scalar>& result);

}  // namespace ritz::runtime
