#include "ritz/fem/stvk.hpp"

#include "instantiate.hpp"

namespace ritz::fem {

template <class E>
EnergyAndForce<E> energy_and_force(const Coordinates<E>& x, const Coordinates<E>& u, const StVK& material) {
  const Coordinates<E> origin_first = relative<E>(x), relative_u = relative<E>(u);
  EnergyAndForce<E> result{0, Coordinates<E>::Zero()};
  for (const auto& sample : E::rule) {
    const auto [gradients, weight] = physical_gradients<E>(origin_first, sample);
    const Matrix<3, 3> G = relative_u * gradients, strain = green_lagrange(G), S = second_piola(material, strain);
    result.energy += weight / 2 * S.cwiseProduct(strain).sum();
    result.force += weight * (S + G * S) * gradients.transpose();
  }
  return result;
}

template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const Coordinates<E>& x, const Coordinates<E>& u,
                                                 const StVK& material) {
  constexpr int n = E::vertices;
  const double lambda = material.lambda(), mu = material.mu();
  const Coordinates<E> origin_first = relative<E>(x), relative_u = relative<E>(u);
  Matrix<3 * n, 3 * n> K = Matrix<3 * n, 3 * n>::Zero();
  for (const auto& sample : E::rule) {
    const auto [gradients, weight] = physical_gradients<E>(origin_first, sample);
    const Matrix<3, 3> G = relative_u * gradients, S = second_piola(material, green_lagrange(G));
    const Matrix<3, 3> F = Matrix<3, 3>::Identity() + G, FFt = F * F.transpose();
    const Matrix<3, n> p = F * gradients.transpose();
    const Matrix<n, n> geometric = weight * gradients * S * gradients.transpose();
    const Matrix<n, n> plain = weight * mu * gradients * gradients.transpose();
    for (int b = 0; b < n; ++b)
      for (int a = 0; a <= b; ++a) {
        auto block = K.template block<3, 3>(3 * a, 3 * b);
        block += weight * (lambda * p.col(a) * p.col(b).transpose() + mu * p.col(b) * p.col(a).transpose());
        block += plain(a, b) * FFt;
        block.diagonal().array() += geometric(a, b);
      }
  }
  K.template triangularView<Eigen::StrictlyLower>() = K.transpose();
  return K;
}

#define INSTANTIATE(E)                                                                                       \
  template EnergyAndForce<E> energy_and_force<E>(const Coordinates<E>&, const Coordinates<E>&, const StVK&); \
  template Matrix<3 * E::vertices, 3 * E::vertices> tangent<E>(const Coordinates<E>&, const Coordinates<E>&, \
                                                               const StVK&);
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
