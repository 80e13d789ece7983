// Sizes and shapes of cells, and the signs of bad ones. Lengths in m.
#pragma once
#include "ritz/fem/cell.hpp"
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// The exact volume ∫ det J, m³, negative for an inverted cell.
template <class E>
double volume(const Coordinates<E>& x);

/// The smallest det J over the points of the element's rule and its corners, m³ (of a straight tetrahedron six times
/// its volume, of a box an eighth). Zero or less: the cell is inverted or folded, at a corner at least.
template <class E>
double smallest_jacobian(const Coordinates<E>& x);

/// The same over the points of the rules for stiffness and mass alone: what the cell's integrals see. Zero or less:
/// they mean nothing. A curved cell may be positive here and not at a corner, where a mid-edge vertex stands at the
/// quarter of its edge.
template <class E>
double smallest_integrated_jacobian(const Coordinates<E>& x);

/// Whether displacements u turn the cell inside out: det(I + ∇u) <= 0 at a point of the element's rule.
template <class E>
bool turned_inside_out(const Coordinates<E>& x, const Coordinates<E>& u);

/// The shortest distance between two corners joined by an edge, m.
template <class E>
double shortest_edge(const Coordinates<E>& x);

/// The smallest angle between two faces of the tetrahedron of the cell's corners, degrees: 70.53 at best, a few degrees
/// for a sliver, whatever the orientation. Only for tetrahedra.
template <class E>
requires(shape(E::type).corners == 4) double smallest_dihedral(const Coordinates<E>& x);

}  // namespace ritz::fem
