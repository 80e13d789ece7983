// The work of one evaluation apart from the pass over the coefficients.
#pragma once
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// An aligned array of `size` zeros.
template <class Scalar>
AlignedVector<Scalar> zeros(Eigen::Index size) {
  return AlignedVector<Scalar>(static_cast<std::size_t>(size), Scalar(0));
}

/// Energy, force and tangent with the quadratic part A added, from the sums of a pass: half of H3 + H4, the force and
/// the energy without A.
template <class Scalar>
void finish(const PolynomialForce<Scalar>& forces, const VectorRef<Scalar>& z, const Vector<Scalar>& sums,
            Scalar& energy, Eigen::Ref<Vector<std::type_identity_t<Scalar>>> force, Matrix<Scalar>& tangent) {
  const Eigen::Index r = forces.r;
  force.noalias() = forces.linear * z;
  energy = z.dot(force) / 2 + sums[sums.size() - 1];
  force += sums.segment(sums.size() - 1 - r, r);
  for (Eigen::Index i = 0, at = 0, n = r; i < r; ++i, at += n--) {
    tangent.col(i).tail(n) = forces.linear.col(i).tail(n) + sums.segment(at, n);
    tangent(i, i) += sums[at];
    tangent.row(i).tail(n) = tangent.col(i).tail(n);
  }
}

}  // namespace ritz::runtime
