// Cells in general position, the same on every machine, for the tests of the elements.
#pragma once
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "ritz/base/random.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/fem/quadrature.hpp"

namespace ritz::fem::testing {

inline Eigen::MatrixXd random_numbers(Eigen::Index rows, Eigen::Index columns, std::uint64_t stream) {
  Eigen::MatrixXd A(rows, columns);
  for (Eigen::Index k = 0; k < A.size(); ++k) A(k) = uniform(stream, static_cast<std::uint64_t>(k));
  return A;
}

template <int m, int n>
Matrix<m, n> random_matrix(std::uint64_t stream) {
  return random_numbers(m, n, stream);
}

inline CellVectors random_vectors(CellType type, std::uint64_t stream) {
  return random_numbers(3, shape(type).vertices, stream);
}

inline CellVectors reference_cell(CellType type) {
  CellVectors x(3, shape(type).vertices);
  for (int a = 0; a < x.cols(); ++a) x.col(a) = Vector<3>(element(type).reference[static_cast<std::size_t>(a)].data());
  return x;
}

/// Each vertex moved a little on its own, then all by one affine map: edges curved, faces warped.
inline CellVectors curved_cell(CellType type, std::uint64_t seed) {
  const Matrix<3, 3> A = 2 * Matrix<3, 3>::Identity() + 0.5 * random_matrix<3, 3>(3 * seed);
  const double size = shape(type).vertices > 10 ? .03 : .06;  // edges of many vertices fold sooner
  const Eigen::MatrixXd moved = reference_cell(type) + size * random_vectors(type, 3 * seed + 1);
  return (A * moved).colwise() + random_matrix<3, 1>(3 * seed + 2);
}

/// The cell moved by a linear map.
inline CellVectors mapped(const Matrix<3, 3>& A, const CellVectors& x) { return A * Eigen::MatrixXd(x); }

/// As curved_cell, with mid-edge vertices in the middle of straight edges.
inline CellVectors straight_cell(CellType type, std::uint64_t seed) {
  CellVectors x = curved_cell(type, seed);
  const auto cell = shape(type);
  for (int e = 0; cell.quadratic() && e < std::ssize(cell.edges); ++e) {
    const auto [i, j] = cell.edges[static_cast<std::size_t>(e)];
    x.col(cell.corners + e) = (x.col(i) + x.col(j)) / 2;
  }
  return x;
}

inline Matrix<3, 3> rotation() { return Eigen::AngleAxisd(1.1, Vector<3>(1, -2, .7).normalized()).toRotationMatrix(); }

/// Coordinates that stay exact when 2^20 is added.
template <class Vectors>
Vectors rounded(Vectors x) {
  for (Eigen::Index k = 0; k < x.size(); ++k) x(k) = std::round(x(k) * 0x1p20) * 0x1p-20;
  return x;
}

template <class Vectors>
Vectors far_away(Vectors x) {
  for (Eigen::Index k = 0; k < x.size(); ++k) x(k) += 0x1p20;
  return x;
}

inline Eigen::VectorXd shape_functions(CellType type, const Point<3>& xi) {
  Eigen::VectorXd N(shape(type).vertices);
  element(type).shape(xi, N.data());
  return N;
}

/// dN_a/dξ, one row for each vertex.
inline Eigen::MatrixXd reference_gradients(CellType type, const Point<3>& xi) {
  Eigen::MatrixXd g(shape(type).vertices, 3);
  element(type).gradient(xi, g.data());
  return g;
}

/// det J of the cell at `xi`.
inline double jacobian(CellType type, const CellVectors& x, const Point<3>& xi) {
  const Matrix<3, 3> J = Eigen::MatrixXd(x) * reference_gradients(type, xi);
  return J.determinant();
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

/// A point of the unit cube in the reference domain of a cell, and how the map stretches volumes there.
inline Sample<3> from_unit_cube(CellType linear, double a, double b, double c) {
  const double s = 1 - c, t = s * (1 - b);
  switch (linear) {
    case CellType::tet4: return {{a * t, b * s, c}, s * t};
    case CellType::wedge6: return {{a * (1 - b), b, 2 * c - 1}, 2 * (1 - b)};
    case CellType::pyramid5: return {{(2 * a - 1) * s, (2 * b - 1) * s, c}, 4 * s * s};
    default: return {{2 * a - 1, 2 * b - 1, 2 * c - 1}, 8};
  }
}

/// Σ w f(xi) over the reference cell by 10 x 10 x 10 points, f returning any Eigen value.
template <class F>
auto integrate_finely(CellType type, const F& f) {
  static const auto line = legendre<10>();
  decltype(f(Point<3>{})) sum = 0 * f(Point<3>{});
  for (const auto& [c, wc] : line)
    for (const auto& [b, wb] : line)
      for (const auto& [a, wa] : line) {
        const auto [xi, stretch] = from_unit_cube(shape(type).linear, a[0], b[0], c[0]);
        sum += wa * wb * wc * stretch * f(xi);
      }
  return sum;
}

inline auto every_cell() { return ::testing::ValuesIn(cell_types); }
inline std::string cell_name(const ::testing::TestParamInfo<CellType>& info) {
  return std::string(shape(info.param).name);
}

}  // namespace ritz::fem::testing
