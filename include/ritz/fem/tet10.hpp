// The quadratic tetrahedron, straight or curved.
#pragma once
#include "ritz/fem/tet4.hpp"

namespace ritz::fem {

/// The quadratic tetrahedron. Its reference tetrahedron is that of Tet4; vertices 4 ... 9 are the midpoints of the
/// edges 01, 12, 20, 03, 13, 23.
struct Tet10 {
  static constexpr CellType type = CellType::tet10;
  static constexpr int vertices = 10;
  /// The two corners of the edge on which mid-edge vertex 4 + e lies.
  static constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  static constexpr std::array<Point<3>, 10> reference = {{{0, 0, 0},
                                                          {1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, 0, 1},
                                                          {.5, 0, 0},
                                                          {.5, .5, 0},
                                                          {0, .5, 0},
                                                          {0, 0, .5},
                                                          {.5, 0, .5},
                                                          {0, .5, .5}}};
  /// The quadrature rule of force, stiffness, modal derivatives and polynomial.
  static constexpr auto& rule = quadrature::tetrahedron_4;
  /// The quadrature rule of the mass: exact for N_a N_b det J on curved cells, of degree 2 + 2 + 3.
  static constexpr auto& mass_rule = quadrature::tetrahedron_64;

  /// N_a at `xi`: L(2L - 1) at a corner and 4 L_i L_j on an edge, where L are the barycentric coordinates.
  static Vector<10> shape(const Point<3>& xi) {
    const Vector<4> L = Tet4::shape(xi);
    Vector<10> N;
    for (int a = 0; a < 4; ++a) N[a] = L[a] * (2 * L[a] - 1);
    for (int e = 0; e < 6; ++e) N[4 + e] = 4 * L[edges[e][0]] * L[edges[e][1]];
    return N;
  }

  /// dN_a/dxi, one row for each vertex.
  static Matrix<10, 3> gradient(const Point<3>& xi) {
    const Vector<4> L = Tet4::shape(xi);
    const Matrix<4, 3> dL = Tet4::gradient(xi);
    Matrix<10, 3> g;
    for (int a = 0; a < 4; ++a) g.row(a) = (4 * L[a] - 1) * dL.row(a);
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edges[e];
      g.row(4 + e) = 4 * (L[i] * dL.row(j) + L[j] * dL.row(i));
    }
    return g;
  }
};

}  // namespace ritz::fem
