// The map from the reference element to the cell, and the gradients from which strains are computed.
#pragma once
#include <Eigen/LU>

#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// The vertices minus the first one, 3 x vertices, m: cells far from the origin then lose no digits.
template <class E>
Coordinates<E> relative(const Coordinates<E>& x) {
  return x.colwise() - x.col(0);
}

/// The Jacobian J_ij = dx_i/dxi_j, m; `relative` is the result of relative().
template <class E>
Matrix<3, 3> jacobian(const Coordinates<E>& relative, const Point<3>& xi) {
  return relative * E::gradient(xi);
}

/// The data of an integral over a cell at one quadrature point.
template <class E>
struct PhysicalGradients {
  Matrix<E::vertices, 3> gradients;  ///< dN_a/dx, one row for each vertex, 1/m
  double weight;                     ///< the rule's weight times det J, m³
};

/// The gradients of the shape functions at `sample`; `relative` is the result of relative(). The displacement gradient
/// is ∇u = u gradients, with u 3 x vertices. Requires det J != 0; a negative weight means an inverted cell (see
/// smallest_jacobian).
template <class E>
PhysicalGradients<E> physical_gradients(const Coordinates<E>& relative, const Sample<3>& sample) {
  const Matrix<E::vertices, 3> reference = E::gradient(sample.xi);
  const Matrix<3, 3> J = relative * reference;
  return {reference * J.inverse(), sample.weight * J.determinant()};
}

}  // namespace ritz::fem
