// The map from the reference element to the cell, and the gradients that strains are made of.
#pragma once
#include <Eigen/LU>

#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// The vertices minus the first one: nothing is lost for cells far from the origin.
template <class E>
Coordinates<E> relative(const Coordinates<E>& x) {
  return x.colwise() - x.col(0);
}

/// J_ij = dx_i/dxi_j, m; `relative` are the coordinates minus the first vertex.
template <class E>
Matrix<3, 3> jacobian(const Coordinates<E>& relative, const Point<3>& xi) {
  return relative * E::gradient(xi);
}

/// What an integral over a cell needs at one quadrature point.
template <class E>
struct PhysicalGradients {
  Matrix<E::vertices, 3> gradients;  ///< dN_a/dx, a row a vertex, 1/m
  double weight;                     ///< the rule's weight times det J, m³
};

/// The shape functions' gradients at `sample`; `relative` as above. The displacement gradient is ∇u = u gradients,
/// with u 3 x vertices. Needs det J != 0; a negative weight is an inverted cell (see smallest_jacobian).
template <class E>
PhysicalGradients<E> physical_gradients(const Coordinates<E>& relative, const Sample<3>& sample) {
  const Matrix<E::vertices, 3> reference = E::gradient(sample.xi);
  const Matrix<3, 3> J = relative * reference;
  return {reference * J.inverse(), sample.weight * J.determinant()};
}

}  // namespace ritz::fem
