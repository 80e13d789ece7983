// What one cell stores and how it resists, at any displacement and for any law.
#pragma once
#include "ritz/fem/material.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {

template <class E>
struct EnergyAndForce {
  double energy;         ///< ∫ W, J
  Coordinates<E> force;  ///< f_a = ∫ P ∇N_a = dE/du_a, N, a column a vertex: what holds the cell in this shape
};

/// Energy and internal force of a cell at rest at `x`, displaced by `u` (3 x vertices, m), by the element's own rule.
/// NaN where the law does not know the state. Allocates nothing.
template <class E>
EnergyAndForce<E> energy_and_force(const Coordinates<E>& x, const Coordinates<E>& u, const Material& material);

/// d(force)/du, N/m, symmetric, not always definite; row 3a + i is component i of vertex a:
/// K_ai,bk = ∫ Σ_jl ∇N_a,j (∂P_ij/∂F_kl) ∇N_b,l. At u = 0 it is stiffness(). Allocates nothing.
template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const Coordinates<E>& x, const Coordinates<E>& u,
                                                 const Material& material);

}  // namespace ritz::fem
