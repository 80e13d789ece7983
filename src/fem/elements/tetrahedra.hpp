// The linear and the quadratic tetrahedron.
#pragma once
#include "shape_functions.hpp"

namespace ritz::fem {

/// Its reference tetrahedron has vertex 0 at the origin and vertices 1, 2, 3 at the unit vectors.
struct Tet4 {
  static constexpr std::array<Point<3>, 4> reference = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  static constexpr auto& rule = quadrature::tetrahedron_1;
  static constexpr auto& mass_rule = quadrature::tetrahedron_4;  ///< degree 1 + 1

  static constexpr Values<4> shape(const Point<3>& xi) { return {1 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]}; }
  static constexpr Gradients<4, 3> gradient(const Point<3>&) { return {{{-1, 1, 0, 0}, {-1, 0, 1, 0}, {-1, 0, 0, 1}}}; }
};

/// L(2L - 1) at a corner and 4 L_i L_j on an edge, where L are the barycentric coordinates.
struct Tet10 {
  static constexpr auto reference = with_midpoints<10>(Tet4::reference, detail::tet_edges);
  static constexpr auto& rule = quadrature::tetrahedron_4;
  static constexpr auto& mass_rule = quadrature::tetrahedron_64;  ///< degree 2 + 2 + 3 on curved cells

  static constexpr Values<10> shape(const Point<3>& xi) {
    return quadratic_shape<10>(Tet4::shape(xi), detail::tet_edges);
  }
  static constexpr Gradients<10, 3> gradient(const Point<3>& xi) {
    return quadratic_gradient<10>(Tet4::shape(xi), Tet4::gradient(xi), detail::tet_edges);
  }
};

}  // namespace ritz::fem
