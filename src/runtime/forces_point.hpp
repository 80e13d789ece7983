// What one evaluation does besides its two products.
#pragma once
#include "ritz/runtime/forces.hpp"

namespace ritz::runtime {

/// The products z_k z_l of all pairs, squares halved: H4 = C times them.
template <class Scalar>
void multiply_out(Eigen::Index r, const Scalar* z, Scalar* products) {
  for (Eigen::Index k = 0; k < r; ++k) {
    const Scalar zk = z[k];
    *products++ = zk * zk / 2;
    for (Eigen::Index l = k + 1; l < r; ++l) *products++ = zk * z[l];
  }
}

template <class Scalar>
AlignedVector<Scalar> zeros(Eigen::Index size) {
  return AlignedVector<Scalar>(static_cast<std::size_t>(size), Scalar(0));
}

/// force += weight (A + H3/2 + H4/3) z, tangent += slope (A + H3 + H4) in the lower triangle.
template <class Scalar>
void add_point(const Forces<Scalar>& forces, const Scalar* z, const Scalar* h3, const Scalar* h4, Scalar weight,
               Scalar slope, Eigen::Ref<Vector<std::type_identity_t<Scalar>>> force, Matrix<Scalar>& tangent) {
  const Eigen::Index r = forces.r;
  const Scalar* linear = forces.linear.data();
  for (Eigen::Index i = 0; i < r; ++i) {
    const Eigen::Index n = r - i;
    const auto run = [n](const Scalar* p) { return Eigen::Map<const Eigen::Array<Scalar, -1, 1>>(p, n); };
    const auto secant = run(linear) + run(h3) * Scalar(0.5) + run(h4) * Scalar(1.0 / 3);
    force[i] += weight * (secant * run(z + i)).sum();
    if (n > 1) force.tail(n - 1).array() += weight * z[i] * secant.tail(n - 1);
    tangent.col(i).tail(n).array() += slope * (run(linear) + run(h3) + run(h4));
    linear += n, h3 += n, h4 += n;
  }
}

/// Ẽ from the products and the two matrices.
template <class Scalar>
Scalar energy_of(const Forces<Scalar>& forces, const AlignedVector<Scalar>& products, const AlignedVector<Scalar>& h3,
                 const AlignedVector<Scalar>& h4) {
  const auto array = [&](const auto& v) {
    return Eigen::Map<const Eigen::Array<Scalar, -1, 1>>(v.data(), forces.linear.size());
  };
  return (array(products) * (array(forces.linear) + array(h3) * Scalar(1.0 / 3) + array(h4) * Scalar(1.0 / 6))).sum();
}

template <class Scalar>
void mirror(Matrix<Scalar>& symmetric) {
  symmetric.template triangularView<Eigen::StrictlyUpper>() = symmetric.transpose();
}

}  // namespace ritz::runtime
