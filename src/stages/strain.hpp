// Small strains of a cell at rest, as the estimates of errors take them: xx yy zz, then xy yz zx of the tensor.
#pragma once
#include <cmath>

#include "ritz/fem/element.hpp"
#include "ritz/fem/material.hpp"

namespace ritz::stages {

using Strain = fem::Vector<6>;

/// The strain of displacements of a cell's vertices (3 x vertices, m) where the shape functions have these gradients.
inline Strain strain(const fem::CellVectors& u, const fem::GradientsRef& gradients) {
  const fem::Matrix<3, 3> G = fem::relative(u).lazyProduct(gradients);
  Strain e;
  e << G(0, 0), G(1, 1), G(2, 2), (G(0, 1) + G(1, 0)) / 2, (G(1, 2) + G(2, 1)) / 2, (G(2, 0) + G(0, 2)) / 2;
  return e;
}

/// e : C : e, twice the energy density, J/m³. C as in fem::ElasticConstants::hooke.
inline double twice_energy(const fem::Matrix<6, 6>& C, Strain e) {
  e.tail<3>() *= 2;
  return e.dot(C * e);
}

/// The octave of Young's modulus: strains are averaged over cells of one octave alone.
inline int octave(const fem::Material& material) { return std::ilogb(material.at_rest().young()); }

}  // namespace ritz::stages
