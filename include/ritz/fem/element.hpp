// Shape functions and quadrature rules of cells and faces, as tables that are made once.
// And the gradients of a cell's shape functions, from which strains are computed, at the points of a quadrature rule.
#pragma once
#include <array>
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

/// The matrix of dN_a/dx, one row for each vertex, 1/m. The displacement gradient is ∇u = u gradients, with u 3 x
/// vertices.
using GradientsRef = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>>;

class IntegrationPoints {
 public:
  /// Those of a cell with vertices `x` at rest, 3 x vertices, m, by its element's rule.
  IntegrationPoints(CellType type, const CellVectors& x) : IntegrationPoints(element(type).rule, x) {}
  /// Those of another table of the cell's element, of at most 36 points. Requires det J != 0 there.
  IntegrationPoints(const Tabulated& table, const CellVectors& x);

  int count() const { return count_; }
  int vertices() const { return vertices_; }
  GradientsRef gradients(int point) const { return {data(point), vertices_, 3}; }
  /// The gradients, column by column.
  const double* data(int point) const { return gradients_.data() + 3 * vertices_ * point; }
  /// The rule's weight times det J, m³; negative in an inverted cell (see smallest_jacobian).
  double weight(int point) const { return weights_[static_cast<std::size_t>(point)]; }

 private:
  int vertices_, count_;
  std::array<double, 27 * 3 * max_cell_vertices> gradients_;
  std::array<double, 36> weights_;
};

}  // namespace ritz::fem
