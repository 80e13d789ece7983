// Shape functions and quadrature rules of cells and faces, as tables that are made once.
#pragma once
#include <span>
#include <vector>

#include "ritz/fem/cell.hpp"
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// Shape functions of n vertices at some points of the reference domain, of dimension d.
struct Tabulated {
  std::vector<double> weights;    ///< one a point
  std::vector<double> values;     ///< n a point
  std::vector<double> gradients;  ///< n x d a point, column by column

  int count() const { return static_cast<int>(weights.size()); }
};

/// The shape functions N_a of a cell (d = 3) or a face (d = 2), and its quadrature rules.
template <int d>
struct Element {
  int vertices;
  std::span<const Point<d>> reference;                      ///< coordinates of the vertices in the reference domain
  void (*shape)(const Point<d>& xi, double* values);        ///< N_a
  void (*gradient)(const Point<d>& xi, double* gradients);  ///< dN_a/dξ_i, vertices x d, column by column
  Tabulated rule;         ///< cells: of force, stiffness, modal derivatives and polynomial; faces: of loads
  Tabulated mass_rule;    ///< cells alone: exact for N_a N_b det J of every shape that the cell can have
  Tabulated at_vertices;  ///< cells alone: with weights of zero, for gradients at the vertices
};

/// The element of a type, made when it is first asked for.
const Element<3>& element(CellType type);
const Element<2>& element(FaceType type);

}  // namespace ritz::fem
