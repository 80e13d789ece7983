// The consistent mass matrix of one cell.
#pragma once
#include "ritz/fem/tet10.hpp"

namespace ritz::fem {

template <class E>
using MassMatrix = Matrix<E::vertices, E::vertices>;

/// The matrix M_s of mass() below, always computed by the element's mass rule, which is exact for every shape that the
/// cell can have.
template <class E>
MassMatrix<E> mass_by_quadrature(const Coordinates<E>& x, double density);

/// Whether the mid-edge vertices are the midpoints of straight edges, up to a few rounding errors of the cell's size.
bool straight(const Coordinates<Tet10>& x);

/// The exact scalar consistent mass M_s, vertices x vertices, kg: M_ab = ∫ ρ N_a N_b. The mass matrix of the cell is
/// M_s ⊗ I₃. `x` are the vertices, 3 x vertices, m; `density` is in kg/m³. Exactly symmetric; positive definite if det
/// J > 0 throughout. Allocates nothing.
template <class E>
MassMatrix<E> mass(const Coordinates<E>& x, double density);

}  // namespace ritz::fem
