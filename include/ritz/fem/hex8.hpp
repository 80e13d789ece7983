// The trilinear hexahedron, fully integrated.
#pragma once
#include "ritz/fem/cell.hpp"
#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// The trilinear hexahedron. Its reference cube is [-1, 1]³, with the bottom face 0123, counter-clockwise seen from
/// above, then the top face 4567.
struct Hex8 {
  static constexpr CellType type = CellType::hex8;
  static constexpr int vertices = 8;
  static constexpr std::array<Point<3>, 8> reference = {
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  /// The quadrature rule of force, stiffness, modal derivatives and polynomial.
  static constexpr auto& rule = quadrature::cube_8;
  /// The quadrature rule of the mass: exact for N_a N_b det J of the trilinear map.
  static constexpr auto& mass_rule = quadrature::cube_27;

  /// N_a at `xi`.
  static Vector<8> shape(const Point<3>& xi) {
    Vector<8> N;
    for (int a = 0; a < 8; ++a) {
      const auto& s = reference[a];
      N[a] = (1 + s[0] * xi[0]) * (1 + s[1] * xi[1]) * (1 + s[2] * xi[2]) / 8;
    }
    return N;
  }

  /// dN_a/dxi, one row for each vertex.
  static Matrix<8, 3> gradient(const Point<3>& xi) {
    Matrix<8, 3> g;
    for (int a = 0; a < 8; ++a) {
      const auto& s = reference[a];
      const double fx = 1 + s[0] * xi[0], fy = 1 + s[1] * xi[1], fz = 1 + s[2] * xi[2];
      g.row(a) << s[0] * fy * fz / 8, s[1] * fx * fz / 8, s[2] * fx * fy / 8;
    }
    return g;
  }
};

}  // namespace ritz::fem
