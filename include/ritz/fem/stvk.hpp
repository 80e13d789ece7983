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
EnergyAndForce<E> energy_and_force(const Coordinates<E>& x, const Coordinates<E>& u, const StVK& material);

/// d(force)/du, N/m, symmetric, not always definite; row 3a + i is component i of vertex a. Its blocks are
/// K_ab = ∫ (∇N_a·S∇N_b) I + λ p_a p_bᵀ + μ p_b p_aᵀ + μ (∇N_a·∇N_b) FFᵀ with p_a = F∇N_a. At u = 0 it is stiffness().
template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const Coordinates<E>& x, const Coordinates<E>& u,
                                                 const StVK& material);

}  // namespace ritz::fem
