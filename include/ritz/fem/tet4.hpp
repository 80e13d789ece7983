// The linear tetrahedron.
#pragma once
#include "ritz/fem/cell.hpp"
#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// The linear tetrahedron. Its reference tetrahedron has vertex 0 at the origin and vertices 1, 2, 3 at the unit
/// vectors.
struct Tet4 {
  static constexpr CellType type = CellType::tet4;
  static constexpr int vertices = 4;
  static constexpr std::array<Point<3>, 4> reference = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  /// The quadrature rule of force, stiffness, modal derivatives and polynomial.
  static constexpr auto& rule = quadrature::tetrahedron_1;
  /// The quadrature rule of the mass: exact for N_a N_b det J.
  static constexpr auto& mass_rule = quadrature::tetrahedron_4;

  /// N_a at `xi`.
  static Vector<4> shape(const Point<3>& xi) { return {1 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]}; }

  /// dN_a/dxi, one row for each vertex.
  static Matrix<4, 3> gradient(const Point<3>&) {
    Matrix<4, 3> g;
    g << -1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    return g;
  }
};

}  // namespace ritz::fem
