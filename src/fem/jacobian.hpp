// The determinant of the map from an element's reference domain to a cell.
#pragma once
#include <Eigen/LU>

#include "ritz/fem/element.hpp"

namespace ritz::fem {

/// det J at a point of a table, m³; `from_first` is the result of relative().
inline double jacobian(const Tabulated& table, int point, const CellVectors& from_first) {
  const GradientsRef reference(table.gradients.data() + 3 * from_first.cols() * point, from_first.cols(), 3);
  const Matrix<3, 3> J = from_first.lazyProduct(reference);
  return J.determinant();
}

}  // namespace ritz::fem
