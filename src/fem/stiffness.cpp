#include "ritz/fem/stiffness.hpp"

#include "instantiate.hpp"

namespace ritz::fem {

template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> stiffness(const Coordinates<E>& x, const ElasticConstants& material) {
  constexpr int n = E::vertices, points = static_cast<int>(E::rule.size());
  const double lambda = material.lambda, mu = material.mu;

  const Coordinates<E> origin_first = relative<E>(x);
  Matrix<3 * n, points> gradients, weighted;  // column q, rows 3a ... 3a+2: ∇N_a at point q
  for (int q = 0; q < points; ++q) {
    const auto [g, weight] = physical_gradients<E>(origin_first, E::rule[q]);
    for (int a = 0; a < n; ++a) gradients.template block<3, 1>(3 * a, q) = g.row(a).transpose();
    weighted.col(q) = weight * gradients.col(q);
  }

  Matrix<3 * n, 3 * n> K;
  for (int b = 0; b < n; ++b)
    for (int a = 0; a <= b; ++a) {
      const Matrix<3, 3> P =
          weighted.template middleRows<3>(3 * a).lazyProduct(gradients.template middleRows<3>(3 * b).transpose());
      auto block = K.template block<3, 3>(3 * a, 3 * b);
      block = lambda * P + mu * P.transpose();
      block.diagonal().array() += mu * P.trace();
    }
  K.template triangularView<Eigen::StrictlyLower>() = K.transpose();
  return K;
}

#define INSTANTIATE(E) \
  template Matrix<3 * E::vertices, 3 * E::vertices> stiffness<E>(const Coordinates<E>&, const ElasticConstants&);
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
