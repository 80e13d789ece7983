// The polynomial force of a reduced model (model::Polynomial): energy, force and tangent in one pass,
//
//   H3_ij = B_ijk z_k,  H4_ij = ½ C_ijkl z_k z_l,
//   Ẽ = (A + H3/3 + H4/6) : zzᵀ / 2,  f̃ = dẼ/dz = (A + H3/2 + H4/3) z,  K̃ = df̃/dz = A + H3 + H4.
//
// H3 and H4 are computed from the coefficients with i ≤ j ≤ k ≤ l alone, with three products for each; after that,
// force and energy cost almost nothing. The coefficients are stored in the order in which this pass reads them, a
// vector register at a time.
//
// Many bodies of one kind can be evaluated at once: the coefficients are read once for as many bodies as a vector
// register holds numbers.
#pragma once
#include "ritz/base/simd.hpp"
#include "ritz/model/model.hpp"
#include "ritz/runtime/vector.hpp"

namespace ritz::runtime {

/// A polynomial force, its coefficients in the order of that pass. Evaluating does not change it: any number of threads
/// can share it.
template <class Scalar>
struct PolynomialForce {
  Eigen::Index r = 0;
  Matrix<Scalar> linear;                 ///< A = K̃(0), r x r, 1/s²
  AlignedVector<Scalar> cubic, quartic;  ///< B and C in the order of src/runtime/kernels.hpp

  Eigen::Index size() const { return r; }
};

/// Brings the coefficients into that order, in double or float. Throws InputError when their numbers do not fit r.
template <class Scalar>
PolynomialForce<Scalar> make_polynomial_force(const model::Polynomial& polynomial);

/// The result of an evaluation of an internal force, and its work arrays; every thread needs its own.
template <class Scalar>
struct Evaluation {
  Scalar energy = 0;       ///< Ẽ, J
  Vector<Scalar> force;    ///< f̃, r numbers, N/√kg
  Matrix<Scalar> tangent;  ///< K̃, r x r, both triangles, 1/s²
  Vector<Scalar> sums;     ///< work array, as those below
  AlignedVector<Scalar> point, room, result;
  std::vector<Evaluation> inner;  ///< of a carried body the body's own; of a cubature its polynomial's
};

/// Allocates the result of evaluate.
template <class Scalar>
Evaluation<Scalar> make_evaluation(const PolynomialForce<Scalar>& force);

/// Writes Ẽ, f̃ and K̃ at z, r numbers, to `result`. Does not allocate. Where z is not finite, the result is not finite
/// either.
template <class Scalar>
void evaluate(const PolynomialForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);

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
