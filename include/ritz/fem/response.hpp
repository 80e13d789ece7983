// The stored energy, internal force and tangent stiffness of one cell, at any displacement and for any law.
#pragma once
#include "ritz/fem/material.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {

template <class E>
struct EnergyAndForce {
  double energy;         ///< ∫ W, J
  Coordinates<E> force;  ///< 3 x vertices, N: column a is f_a = ∫ P ∇N_a = dE/du_a, which holds the cell in this shape
};

/// The energy and the internal force of a cell with vertices `x` at rest (3 x vertices, m) and displacements `u` (3 x
/// vertices, m), by the element's rule. NaN where the law does not admit the state. Allocates nothing.
template <class E>
EnergyAndForce<E> energy_and_force(const Coordinates<E>& x, const Coordinates<E>& u, const Material& material);

/// The tangent stiffness d(force)/du, N/m, symmetric but not always definite. Row 3a + i is component i of vertex a:
/// K_ai,bk = ∫ Σ_jl ∇N_a,j (∂P_ij/∂F_kl) ∇N_b,l. At u = 0 it equals stiffness(). Allocates nothing.
template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const Coordinates<E>& x, const Coordinates<E>& u,
                                                 const Material& material);

}  // namespace ritz::fem
