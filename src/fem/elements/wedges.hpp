// The linear and the quadratic wedge (a triangular prism).
#pragma once
#include "faces.hpp"

namespace ritz::fem {

/// The reference triangle 012 at ζ = 1, the triangle 345 at ζ = -1: L_i (1 ± ζ)/2, with the triangle's barycentric
/// coordinates L. One point in the triangle, as in Abaqus and CalculiX: more points are much stiffer in bending. A cell
/// twists about its own axis without a force; a second triangle in the cross-section of a body prevents it.
struct Wedge6 {
  static constexpr std::array<Point<3>, 6> reference = {
      {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, -1}, {1, 0, -1}, {0, 1, -1}}};
  static constexpr auto& rule = quadrature::wedge_2;
  static constexpr auto& mass_rule = quadrature::wedge_36;  ///< degree 1 + 1 + 1 in the triangle, 1 + 1 + 2 along ζ

  static constexpr Values<6> shape(const Point<3>& xi) {
    const auto L = Tri3::shape({xi[0], xi[1]});
    const double low = (1 - xi[2]) / 2, high = (1 + xi[2]) / 2;
    return {L[0] * high, L[1] * high, L[2] * high, L[0] * low, L[1] * low, L[2] * low};
  }
  static constexpr Gradients<6, 3> gradient(const Point<3>& xi) {
    const auto L = Tri3::shape({xi[0], xi[1]});
    const auto dL = Tri3::gradient({});
    Gradients<6, 3> g = {};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 2; ++d) {
        g[d][i] = dL[d][i] * (1 + xi[2]) / 2;
        g[d][3 + i] = dL[d][i] * (1 - xi[2]) / 2;
      }
      g[2][i] = L[i] / 2;
      g[2][3 + i] = -L[i] / 2;
    }
    return g;
  }
};

/// With s = ±1 on the upper and the lower triangle: L((2L - 1)(1 + sζ) - (1 - ζ²))/2 at a corner, 2 L_i L_j (1 + sζ) on
/// an edge of a triangle, L_i (1 - ζ²) on an edge between the triangles.
struct Wedge15 {
  static constexpr auto reference = with_midpoints<15>(Wedge6::reference, detail::wedge_edges);
  static constexpr auto& rule = quadrature::wedge_9;
  static constexpr auto& mass_rule = quadrature::wedge_125;  ///< degree 2 + 2 + 4 in the triangle, 2 + 2 + 5 along ζ

  static constexpr Values<15> shape(const Point<3>& xi) {
    const auto L = Tri3::shape({xi[0], xi[1]});
    const double z = xi[2], bubble = 1 - z * z;
    Values<15> N = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      N[i] = L[i] * ((2 * L[i] - 1) * (1 + z) - bubble) / 2;
      N[3 + i] = L[i] * ((2 * L[i] - 1) * (1 - z) - bubble) / 2;
      N[6 + i] = 2 * L[i] * L[j] * (1 + z);
      N[9 + i] = 2 * L[i] * L[j] * (1 - z);
      N[12 + i] = L[i] * bubble;
    }
    return N;
  }
  static constexpr Gradients<15, 3> gradient(const Point<3>& xi) {
    const auto L = Tri3::shape({xi[0], xi[1]});
    const auto dL = Tri3::gradient({});
    const double z = xi[2], bubble = 1 - z * z;
    Gradients<15, 3> g = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      for (std::size_t d = 0; d < 2; ++d) {
        const double product = dL[d][i] * L[j] + L[i] * dL[d][j];
        g[d][i] = dL[d][i] * ((4 * L[i] - 1) * (1 + z) - bubble) / 2;
        g[d][3 + i] = dL[d][i] * ((4 * L[i] - 1) * (1 - z) - bubble) / 2;
        g[d][6 + i] = 2 * product * (1 + z);
        g[d][9 + i] = 2 * product * (1 - z);
        g[d][12 + i] = dL[d][i] * bubble;
      }
      g[2][i] = L[i] * (2 * z + (2 * L[i] - 1)) / 2;
      g[2][3 + i] = L[i] * (2 * z - (2 * L[i] - 1)) / 2;
      g[2][6 + i] = 2 * L[i] * L[j];
      g[2][9 + i] = -2 * L[i] * L[j];
      g[2][12 + i] = -2 * L[i] * z;
    }
    return g;
  }
};

}  // namespace ritz::fem
