// Sizes and shape measures of cells, by which bad cells are found. `x` are the vertices at rest, 3 x vertices, m.
#pragma once
#include "ritz/fem/cell.hpp"
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// The exact volume ∫ det J, m³; negative for an inverted cell.
template <class E>
double volume(const Coordinates<E>& x);

/// The smallest det J over the quadrature points of the element's rule and the corners, m³; for a straight tetrahedron
/// six times its volume, for a box an eighth. If it is not positive, the cell is inverted or folded, at least at a
/// corner.
template <class E>
double smallest_jacobian(const Coordinates<E>& x);

/// The smallest det J over the quadrature points of the stiffness and mass rules alone, m³. If it is not positive, the
/// integrals over the cell are meaningless. A curved cell may be positive there but not at a corner: where a mid-edge
/// vertex stands at a quarter of its edge.
template <class E>
double smallest_integrated_jacobian(const Coordinates<E>& x);

/// Whether the displacements u, 3 x vertices, m, turn the cell inside out: det(I + ∇u) <= 0 at a point of the element's
/// rule.
template <class E>
bool turned_inside_out(const Coordinates<E>& x, const Coordinates<E>& u);

/// The length of the shortest edge, measured between its corners, m.
template <class E>
double shortest_edge(const Coordinates<E>& x);

/// The smallest dihedral angle of the tetrahedron formed by the cell's corners, degrees: 70.53 at best, a few degrees
/// for a sliver, regardless of orientation. For tetrahedra only.
template <class E>
requires(shape(E::type).corners == 4) double smallest_dihedral(const Coordinates<E>& x);

}  // namespace ritz::fem
