// What shape functions are composed of. Each element or face is a struct with the reference coordinates of its
// vertices, its quadrature rules, its shape functions N_a and their gradients.
#pragma once
#include <array>
#include <cstddef>

#include "ritz/fem/cell.hpp"
#include "ritz/fem/quadrature.hpp"

namespace ritz::fem {

/// N_a, one a vertex.
template <std::size_t n>
using Values = std::array<double, n>;

/// dN_a/dξ_i: [i][a].
template <std::size_t n, std::size_t d>
using Gradients = std::array<std::array<double, n>, d>;

/// The corners, then the middles of the edges.
template <std::size_t n, std::size_t d, std::size_t corners, std::size_t edges>
constexpr std::array<std::array<double, d>, n> with_midpoints(const std::array<std::array<double, d>, corners>& from,
                                                              const std::array<Edge, edges>& all) {
  static_assert(n == corners + edges);
  std::array<std::array<double, d>, n> points = {};
  for (std::size_t a = 0; a < corners; ++a) points[a] = from[a];
  for (std::size_t e = 0; e < edges; ++e)
    for (std::size_t i = 0; i < d; ++i)
      points[corners + e][i] =
          (from[static_cast<std::size_t>(all[e][0])][i] + from[static_cast<std::size_t>(all[e][1])][i]) / 2;
  return points;
}

/// The quadratic functions of a simplex with barycentric coordinates L.
template <std::size_t n, std::size_t corners, std::size_t edges>
constexpr Values<n> quadratic_shape(const Values<corners>& L, const std::array<Edge, edges>& all) {
  Values<n> N = {};
  for (std::size_t a = 0; a < corners; ++a) N[a] = L[a] * (2 * L[a] - 1);
  for (std::size_t e = 0; e < edges; ++e)
    N[corners + e] = 4 * L[static_cast<std::size_t>(all[e][0])] * L[static_cast<std::size_t>(all[e][1])];
  return N;
}

template <std::size_t n, std::size_t d, std::size_t corners, std::size_t edges>
constexpr Gradients<n, d> quadratic_gradient(const Values<corners>& L, const Gradients<corners, d>& dL,
                                             const std::array<Edge, edges>& all) {
  Gradients<n, d> g = {};
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t a = 0; a < corners; ++a) g[i][a] = (4 * L[a] - 1) * dL[i][a];
    for (std::size_t e = 0; e < edges; ++e) {
      const auto a = static_cast<std::size_t>(all[e][0]), b = static_cast<std::size_t>(all[e][1]);
      g[i][corners + e] = 4 * (L[a] * dL[i][b] + L[b] * dL[i][a]);
    }
  }
  return g;
}

}  // namespace ritz::fem
