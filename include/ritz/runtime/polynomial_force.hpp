// The polynomial force of a reduced model (model::Polynomial): energy, force and tangent in one pass,
//
//   H3_ij = B_ijk z_k,  H4_ij = ½ C_ijkl z_k z_l,
//   Ẽ = (A + H3/3 + H4/6) : zzᵀ / 2,  f̃ = dẼ/dz = (A + H3/2 + H4/3) z,  K̃ = df̃/dz = A + H3 + H4.
//
// The tangent's two matrices follow from the unique coefficients i ≤ j ≤ k ≤ l alone, three products for each; force
// and energy cost next to nothing then. The coefficients are laid out for that pass, a register's width at a time.
#pragma once
#include "ritz/base/aligned.hpp"
#include "ritz/model/model.hpp"
#include "ritz/runtime/vector.hpp"

namespace ritz::runtime {

/// The coefficients, laid out; constant while they are used, by any number of threads.
template <class Scalar>
struct PolynomialForce {
  Eigen::Index r = 0;
  Matrix<Scalar> linear;                 ///< A = K̃(0), r x r
  AlignedVector<Scalar> cubic, quartic;  ///< B and C in the order of src/runtime/kernels.hpp

  Eigen::Index size() const { return r; }
};

/// Lays the polynomial out, in double or float. Throws InputError when its arrays do not have the sizes that r says.
template <class Scalar>
PolynomialForce<Scalar> make_polynomial_force(const model::Polynomial& polynomial);

/// What one evaluation of an internal force returns, and room for it; one a thread.
template <class Scalar>
struct Evaluation {
  Scalar energy = 0;       ///< Ẽ, J
  Vector<Scalar> force;    ///< f̃, r
  Matrix<Scalar> tangent;  ///< K̃, r x r, both triangles
  Vector<Scalar> sums;
  AlignedVector<Scalar> point, room, result;
  std::vector<Evaluation> carried;  ///< of a body that a frame carries: the body's own
};

template <class Scalar>
Evaluation<Scalar> make_evaluation(const PolynomialForce<Scalar>& force);

/// Ẽ, f̃ and K̃ at z. Does not allocate. What is not finite in z is not finite in the result.
template <class Scalar>
void evaluate(const PolynomialForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);

}  // namespace ritz::runtime
