// Cells in general position, the same on every machine, for the tests of the elements.
#pragma once
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ritz/base/random.hpp"
#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem::testing {

template <int m, int n>
Matrix<m, n> random_matrix(std::uint64_t stream) {
  Matrix<m, n> A;
  for (int k = 0; k < m * n; ++k) A(k) = uniform(stream, static_cast<std::uint64_t>(k));
  return A;
}

/// The matrix as one of no fixed size: what a test does with it is compiled once for all cells.
template <int m, int n>
Eigen::MatrixXd any_size(const Matrix<m, n>& A) {
  return Eigen::Map<const Eigen::MatrixXd>(A.data(), m, n);
}

/// And back: the coordinates of the vertices of an E.
template <class E>
Coordinates<E> coordinates(const Eigen::MatrixXd& x) {
  Coordinates<E> fixed;
  std::copy_n(x.data(), fixed.size(), fixed.data());
  return fixed;
}

template <class E>
Coordinates<E> reference_cell() {
  Coordinates<E> x;
  for (int a = 0; a < E::vertices; ++a) x.col(a) = Vector<3>(E::reference[a].data());
  return x;
}

/// Each vertex moved a little on its own, then all by one affine map: edges curved (Tet10), faces warped (Hex8).
inline Eigen::MatrixXd curved(const Eigen::MatrixXd& x, const Eigen::MatrixXd& random, std::uint64_t seed) {
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + 0.5 * random_matrix<3, 3>(3 * seed);
  const Eigen::MatrixXd moved = x + 0.06 * random;
  return (A * moved).colwise() + random_matrix<3, 1>(3 * seed + 2);
}

template <class E>
Coordinates<E> curved_cell(std::uint64_t seed) {
  return coordinates<E>(
      curved(any_size(reference_cell<E>()), any_size(random_matrix<3, E::vertices>(3 * seed + 1)), seed));
}

/// The cell moved by a linear map.
template <class E>
Coordinates<E> mapped(const Matrix<3, 3>& A, const Coordinates<E>& x) {
  return coordinates<E>(A * any_size(x));
}

inline Coordinates<Tet10> straightened(Coordinates<Tet10> x) {
  for (int e = 0; e < 6; ++e) x.col(4 + e) = (x.col(Tet10::edges[e][0]) + x.col(Tet10::edges[e][1])) / 2;
  return x;
}

/// As curved_cell, with mid-edge vertices in the middle of straight edges.
template <class E>
Coordinates<E> straight_cell(std::uint64_t seed) {
  if constexpr (E::type == CellType::tet10) return straightened(curved_cell<E>(seed));
  return curved_cell<E>(seed);
}

inline Matrix<3, 3> rotation() { return Eigen::AngleAxisd(1.1, Vector<3>(1, -2, .7).normalized()).toRotationMatrix(); }

/// Coordinates that stay exact when 2^20 is added.
template <class E>
Coordinates<E> rounded(Coordinates<E> x) {
  for (int k = 0; k < x.size(); ++k) x(k) = std::round(x(k) * 0x1p20) * 0x1p-20;
  return x;
}

template <class E>
Coordinates<E> far_away(Coordinates<E> x) {
  for (int k = 0; k < x.size(); ++k) x(k) += 0x1p20;
  return x;
}

/// Gauss-Legendre on [0, 1] by Newton's method, n points; independent of the rules under test.
template <int n>
Rule<1, n> legendre() {
  Rule<1, n> rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + .75) / (n + .5)), slope = 0;
    for (int step = 0; step < 20; ++step) {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k) before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule[i] = {{(1 + x) / 2}, 1 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

/// Σ w f(xi) over E's reference cell by 10 x 10 x 10 points, f returning any Eigen value.
template <class E, class F>
auto integrate_finely(const F& f) {
  static const auto line = legendre<10>();
  decltype(f(Point<3>{})) sum = 0 * f(Point<3>{});
  for (const auto& [c, wc] : line)
    for (const auto& [b, wb] : line)
      for (const auto& [a, wa] : line) {
        const double w = wa * wb * wc, s = 1 - c[0], t = s * (1 - b[0]);
        if constexpr (E::type == CellType::hex8) sum += 8 * w * f({2 * a[0] - 1, 2 * b[0] - 1, 2 * c[0] - 1});
        else sum += w * s * t * f({a[0] * t, b[0] * s, c[0]});
      }
  return sum;
}

using Elements = ::testing::Types<Tet4, Tet10, Hex8>;

}  // namespace ritz::fem::testing
