// Sizes and shape measures of cells, by which bad cells are found. `x` are the vertices at rest, 3 x vertices, m.
#pragma once
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// The exact volume ∫ det J, m³; negative for an inverted cell.
double volume(CellType type, const CellVectors& x);

/// The smallest det J over the quadrature points of the element's rule and the corners, m³; for a straight tetrahedron
/// six times its volume, for a box an eighth. If it is not positive, the cell is inverted or folded, at least at a
/// corner.
double smallest_jacobian(CellType type, const CellVectors& x);

/// The smallest det J over the quadrature points of the stiffness and mass rules alone, m³. If it is not positive, the
/// integrals over the cell are meaningless. A curved cell may be positive there but not at a corner: where a mid-edge
/// vertex stands at a quarter of its edge.
double smallest_integrated_jacobian(CellType type, const CellVectors& x);

/// Whether the displacements u, 3 x vertices, m, turn the cell inside out: det(I + ∇u) <= 0 at a point of the element's
/// rule.
bool turned_inside_out(CellType type, const CellVectors& x, const CellVectors& u);

/// Whether the mid-edge vertices are the midpoints of straight edges, up to a few rounding errors of the cell's size.
/// A linear cell is straight.
bool straight(CellType type, const CellVectors& x);

/// The length of the shortest edge, measured between its corners, m.
double shortest_edge(CellType type, const CellVectors& x);

/// The smallest dihedral angle of the tetrahedron formed by the first four vertices, degrees: 70.53 at best, a few
/// degrees for a sliver, regardless of orientation.
double smallest_dihedral(const CellVectors& x);

}  // namespace ritz::fem
