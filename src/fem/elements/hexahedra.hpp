// The trilinear hexahedron and the quadratic one of the serendipity family.
#pragma once
#include "shape_functions.hpp"

namespace ritz::fem {

/// Its reference cube is [-1, 1]³, with the bottom face 0123, counter-clockwise seen from above, then the top face
/// 4567.
struct Hex8 {
  static constexpr std::array<Point<3>, 8> reference = {
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  static constexpr auto& rule = quadrature::cube_8;
  static constexpr auto& mass_rule = quadrature::cube_27;  ///< degree 1 + 1 + 2 in each coordinate

  static constexpr Values<8> shape(const Point<3>& xi) {
    Values<8> N = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const auto& s = reference[a];
      N[a] = (1 + s[0] * xi[0]) * (1 + s[1] * xi[1]) * (1 + s[2] * xi[2]) / 8;
    }
    return N;
  }
  static constexpr Gradients<8, 3> gradient(const Point<3>& xi) {
    Gradients<8, 3> g = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const auto& s = reference[a];
      const double fx = 1 + s[0] * xi[0], fy = 1 + s[1] * xi[1], fz = 1 + s[2] * xi[2];
      g[0][a] = s[0] * fy * fz / 8;
      g[1][a] = s[1] * fx * fz / 8;
      g[2][a] = s[2] * fx * fy / 8;
    }
    return g;
  }
};

/// With s the reference coordinates of a vertex: Π(1 + s_i ξ_i)(Σ s_i ξ_i − 2)/8 at a corner, and on an edge along ξ_k
/// (1 − ξ_k²) Π_{i≠k}(1 + s_i ξ_i)/4.
struct Hex20 {
  static constexpr auto reference = with_midpoints<20>(Hex8::reference, detail::hex_edges);
  static constexpr auto& rule = quadrature::cube_27;
  static constexpr auto& mass_rule = quadrature::cube_125;  ///< degree 2 + 2 + 5 in each coordinate on curved cells

  static constexpr Values<20> shape(const Point<3>& xi) {
    Values<20> N = {};
    for (std::size_t a = 0; a < 20; ++a) {
      double product = 1, sum = -2;
      for (std::size_t i = 0; i < 3; ++i) {
        const double s = reference[a][i];
        product *= s == 0 ? 1 - xi[i] * xi[i] : 1 + s * xi[i];
        sum += s * xi[i];
      }
      N[a] = a < 8 ? product * sum / 8 : product / 4;
    }
    return N;
  }
  static constexpr Gradients<20, 3> gradient(const Point<3>& xi) {
    Gradients<20, 3> g = {};
    for (std::size_t a = 0; a < 20; ++a) {
      Values<3> factor = {}, slope = {};
      double sum = -2;
      for (std::size_t i = 0; i < 3; ++i) {
        const double s = reference[a][i];
        factor[i] = s == 0 ? 1 - xi[i] * xi[i] : 1 + s * xi[i];
        slope[i] = s == 0 ? -2 * xi[i] : s;
        sum += s * xi[i];
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const double others = factor[(i + 1) % 3] * factor[(i + 2) % 3];
        g[i][a] = a < 8 ? others * (slope[i] * sum + factor[i] * reference[a][i]) / 8 : others * slope[i] / 4;
      }
    }
    return g;
  }
};

}  // namespace ritz::fem
