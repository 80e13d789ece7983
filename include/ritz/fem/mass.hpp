// The consistent mass of one cell.
#pragma once
#include "ritz/fem/tet10.hpp"

namespace ritz::fem {

template <class E>
using MassMatrix = Matrix<E::vertices, E::vertices>;

/// By the element's mass rule, which is exact for every shape the cell can have.
template <class E>
MassMatrix<E> mass_by_quadrature(const Coordinates<E>& x, double density);

/// Whether the mid-edge vertices stand in the middle of straight edges, to a few roundings of the cell's size.
bool straight(const Coordinates<Tet10>& x);

/// The exact scalar consistent mass M_s, M_ab = ∫ ρ N_a N_b, kg; the cell's mass matrix is M_s ⊗ I₃.
/// `density` in kg/m³. Exactly symmetric; positive definite when det J > 0 throughout. Allocates nothing.
template <class E>
MassMatrix<E> mass(const Coordinates<E>& x, double density);

}  // namespace ritz::fem
