// What one cell of St. Venant-Kirchhoff material stores and how it resists, at any displacement.
#pragma once
#include "ritz/fem/material.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {

/// E = ½(∇u + ∇uᵀ + ∇uᵀ∇u), Green-Lagrange: from ∇u, not from FᵀF − I, which loses small strains.
inline Matrix<3, 3> green_lagrange(const Matrix<3, 3>& G) {
  Matrix<3, 3> product = G.transpose().lazyProduct(G);
  return (G + G.transpose() + product) / 2;
}

/// S = λ tr(E) I + 2μ E, second Piola-Kirchhoff, Pa.
inline Matrix<3, 3> second_piola(const StVK& material, const Matrix<3, 3>& strain) {
  Matrix<3, 3> S = 2 * material.mu() * strain;
  S.diagonal().array() += material.lambda() * strain.trace();
  return S;
}

template <class E>
struct EnergyAndForce {
  double energy;         ///< ∫ ½ S : E, J
  Coordinates<E> force;  ///< dE/du, N, a column a vertex: what holds the cell in this shape
};

/// Energy and internal force of a cell at rest at `x`, displaced by `u` (3 x vertices, m), by the element's own rule.
/// Allocates nothing.
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

/// d(force)/du, N/m, symmetric, not always definite; row 3a + i is component i of vertex a. Its blocks are
/// K_ab = ∫ (∇N_a·S∇N_b) I + λ p_a p_bᵀ + μ p_b p_aᵀ + μ (∇N_a·∇N_b) FFᵀ with p_a = F∇N_a. At u = 0 it is stiffness().
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

}  // namespace ritz::fem
