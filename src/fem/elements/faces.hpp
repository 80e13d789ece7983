// The linear and quadratic triangle and quadrilateral, which are the faces of cells.
#pragma once
#include "shape_functions.hpp"

namespace ritz::fem {

inline constexpr std::array<Edge, 3> triangle_edges = {{{0, 1}, {1, 2}, {2, 0}}};
inline constexpr std::array<Edge, 4> quadrilateral_edges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};

/// Reference corners: (0,0), (1,0), (0,1).
struct Tri3 {
  static constexpr std::array<Point<2>, 3> reference = {{{0, 0}, {1, 0}, {0, 1}}};
  static constexpr auto& rule = quadrature::triangle_1;

  static constexpr Values<3> shape(const Point<2>& xi) { return {1 - xi[0] - xi[1], xi[0], xi[1]}; }
  static constexpr Gradients<3, 2> gradient(const Point<2>&) { return {{{-1, 1, 0}, {-1, 0, 1}}}; }
};

struct Tri6 {
  static constexpr auto reference = with_midpoints<6>(Tri3::reference, triangle_edges);
  static constexpr auto& rule = quadrature::triangle_12;

  static constexpr Values<6> shape(const Point<2>& xi) { return quadratic_shape<6>(Tri3::shape(xi), triangle_edges); }
  static constexpr Gradients<6, 2> gradient(const Point<2>& xi) {
    return quadratic_gradient<6>(Tri3::shape(xi), Tri3::gradient(xi), triangle_edges);
  }
};

/// The reference square [-1, 1]², vertices counter-clockwise.
struct Quad4 {
  static constexpr std::array<Point<2>, 4> reference = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  static constexpr auto& rule = quadrature::square_9;

  static constexpr Values<4> shape(const Point<2>& xi) {
    Values<4> N = {};
    for (std::size_t a = 0; a < 4; ++a) N[a] = (1 + reference[a][0] * xi[0]) * (1 + reference[a][1] * xi[1]) / 4;
    return N;
  }
  static constexpr Gradients<4, 2> gradient(const Point<2>& xi) {
    Gradients<4, 2> g = {};
    for (std::size_t a = 0; a < 4; ++a) {
      const auto [s, t] = reference[a];
      g[0][a] = s * (1 + t * xi[1]) / 4;
      g[1][a] = t * (1 + s * xi[0]) / 4;
    }
    return g;
  }
};

/// The face of Hex20, with its shape functions at ζ = ±1: Π(1 + s_i ξ_i)(Σ s_i ξ_i − 1)/4 at a corner, and on an edge
/// along ξ_k (1 − ξ_k²)(1 + s_i ξ_i)/2.
struct Quad8 {
  static constexpr auto reference = with_midpoints<8>(Quad4::reference, quadrilateral_edges);
  static constexpr auto& rule = quadrature::square_9;

  static constexpr Values<8> shape(const Point<2>& xi) {
    Values<8> N = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const auto [s, t] = reference[a];
      const double f = s == 0 ? 1 - xi[0] * xi[0] : 1 + s * xi[0], h = t == 0 ? 1 - xi[1] * xi[1] : 1 + t * xi[1];
      N[a] = a < 4 ? f * h * (s * xi[0] + t * xi[1] - 1) / 4 : f * h / 2;
    }
    return N;
  }
  static constexpr Gradients<8, 2> gradient(const Point<2>& xi) {
    Gradients<8, 2> g = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const auto [s, t] = reference[a];
      const double f = s == 0 ? 1 - xi[0] * xi[0] : 1 + s * xi[0], h = t == 0 ? 1 - xi[1] * xi[1] : 1 + t * xi[1];
      const double df = s == 0 ? -2 * xi[0] : s, dh = t == 0 ? -2 * xi[1] : t, sum = s * xi[0] + t * xi[1] - 1;
      g[0][a] = a < 4 ? h * (df * sum + f * s) / 4 : df * h / 2;
      g[1][a] = a < 4 ? f * (dh * sum + h * t) / 4 : f * dh / 2;
    }
    return g;
  }
};

}  // namespace ritz::fem
