// The gradients of a cell's shape functions, from which strains are computed, at the points of a quadrature rule.
#pragma once
#include <array>

#include "ritz/fem/element.hpp"

namespace ritz::fem {

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
