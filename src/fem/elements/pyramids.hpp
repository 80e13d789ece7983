// The pyramid with five vertices, which joins hexahedra to tetrahedra.
#pragma once
#include "shape_functions.hpp"

namespace ritz::fem {

/// The base [-1, 1]² at ζ = 0, the apex at ζ = 1. With w = 1 − ζ and the base coordinates s, t of a vertex:
/// (w + sξ)(w + tη)/4w, and ζ at the apex [Bedrosian 1992]. They are rational, linear on every triangle and bilinear on
/// the base, so that cells of other types fit; in collapsed coordinates ξ/w, η/w, ζ they are polynomials, and the rules
/// are exact there. At the apex, where gradients depend on the direction of approach, those along the axis are taken.
struct Pyramid5 {
  static constexpr std::array<Point<3>, 5> reference = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}};
  static constexpr auto& rule = quadrature::pyramid_8;
  static constexpr auto& mass_rule = quadrature::pyramid_36;  ///< degree 4 in collapsed ξ and η, 2 in ζ

  static constexpr Values<5> shape(const Point<3>& xi) {
    const double w = 1 - xi[2];
    Values<5> N = {};
    if (w != 0)
      for (std::size_t a = 0; a < 4; ++a)
        N[a] = (w + reference[a][0] * xi[0]) * (w + reference[a][1] * xi[1]) / (4 * w);
    N[4] = xi[2];
    return N;
  }
  static constexpr Gradients<5, 3> gradient(const Point<3>& xi) {
    const double w = 1 - xi[2], x = w == 0 ? 0 : xi[0] / w, y = w == 0 ? 0 : xi[1] / w;
    Gradients<5, 3> g = {};
    for (std::size_t a = 0; a < 4; ++a) {
      const double s = reference[a][0], t = reference[a][1];
      g[0][a] = s * (1 + t * y) / 4;
      g[1][a] = t * (1 + s * x) / 4;
      g[2][a] = -(1 - s * x * t * y) / 4;
    }
    g[2][4] = 1;
    return g;
  }
};

}  // namespace ritz::fem
