// Each rule against the closed-form moments of monomials, up to its degree and not beyond.
#include "ritz/fem/quadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ritz::fem {
namespace {

double factorial(int k) { return std::tgamma(k + 1); }

/// ∫ Π x_i^p_i over the unit simplex of dimension d.
template <int d>
double simplex_moment(const std::array<int, d>& p) {
  double product = 1;
  int degree = d;
  for (const int k : p) {
    product *= factorial(k);
    degree += k;
  }
  return product / factorial(degree);
}

template <int d>
double cube_moment(const std::array<int, d>& p) {
  double product = 1;
  for (const int k : p) product *= k % 2 ? 0 : 2. / (k + 1);
  return product;
}

template <std::size_t d>
int total_degree(const std::array<int, d>& p) {
  return std::accumulate(p.begin(), p.end(), 0);
}

template <std::size_t d>
int largest_exponent(const std::array<int, d>& p) {
  return *std::max_element(p.begin(), p.end());
}

/// The largest error over all monomials x^p with order(p) = degree.
template <int d, std::size_t n, class Order, class Moment>
double worst(const Rule<d, n>& rule, int degree, const Order& order, const Moment& moment) {
  double error = 0;
  for (int code = 0; code < std::pow(degree + 1, d); ++code) {
    std::array<int, d> p;
    for (int i = 0, rest = code; i < d; ++i, rest /= degree + 1) p[i] = rest % (degree + 1);
    if (order(p) != degree) continue;
    double integral = 0;
    for (const auto& [xi, weight] : rule) {
      double f = weight;
      for (int i = 0; i < d; ++i) f *= std::pow(xi[i], p[i]);
      integral += f;
    }
    error = std::max(error, std::abs(integral - moment(p)));
  }
  return error;
}

template <int d, std::size_t n>
void expect_simplex_degree(const Rule<d, n>& rule, int degree) {
  for (int k = 0; k <= degree; ++k)
    EXPECT_LT(worst(rule, k, total_degree<d>, simplex_moment<d>), n > 12 ? 2e-16 : 1e-16) << "degree " << k;
  EXPECT_GT(worst(rule, degree + 1, total_degree<d>, simplex_moment<d>), 1e-8);
  for (const auto& [xi, weight] : rule) {
    double rest = 1;
    for (const double x : xi) {
      EXPECT_GT(x, 0);
      rest -= x;
    }
    EXPECT_GT(rest, 0);
    EXPECT_GT(weight, 0);
  }
}

template <int d, std::size_t n>
void expect_cube_degree(const Rule<d, n>& rule, int degree) {
  for (int k = 0; k <= degree; ++k)
    EXPECT_LT(worst(rule, k, largest_exponent<d>, cube_moment<d>), 1e-14) << "degree " << k;
  EXPECT_GT(worst(rule, degree + 1, largest_exponent<d>, cube_moment<d>), 1e-3);
}

TEST(Quadrature, Tetrahedra) {
  expect_simplex_degree(quadrature::tetrahedron_1, 1);
  expect_simplex_degree(quadrature::tetrahedron_4, 2);
  expect_simplex_degree(quadrature::tetrahedron_64, 7);
}

TEST(Quadrature, Triangles) {
  expect_simplex_degree(quadrature::triangle_1, 1);
  expect_simplex_degree(quadrature::triangle_3, 2);
  expect_simplex_degree(quadrature::triangle_12, 6);
  expect_simplex_degree(quadrature::triangle_25, 9);
}

TEST(Quadrature, CubesAndSquares) {
  expect_cube_degree(quadrature::cube_8, 3);
  expect_cube_degree(quadrature::cube_27, 5);
  expect_cube_degree(quadrature::cube_125, 9);
  expect_cube_degree(quadrature::square_9, 5);
}

/// The largest error over monomials of at most `degree` in the triangle and `along` in ζ.
template <std::size_t n>
double worst_in_wedge(const Rule<3, n>& rule, int degree, int along) {
  double error = 0;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j)
      for (int k = 0; k <= along; ++k) {
        double integral = 0;
        for (const auto& [xi, weight] : rule)
          integral += weight * std::pow(xi[0], i) * std::pow(xi[1], j) * std::pow(xi[2], k);
        error = std::max(error, std::abs(integral - simplex_moment<2>({i, j}) * cube_moment<1>({k})));
      }
  return error;
}

TEST(Quadrature, Wedges) {
  EXPECT_LT(worst_in_wedge(quadrature::wedge_2, 1, 3), 1e-15);
  EXPECT_LT(worst_in_wedge(quadrature::wedge_9, 2, 5), 1e-15);
  EXPECT_LT(worst_in_wedge(quadrature::wedge_36, 6, 5), 1e-15);
  EXPECT_LT(worst_in_wedge(quadrature::wedge_125, 9, 9), 1e-15);
  EXPECT_GT(worst_in_wedge(quadrature::wedge_125, 10, 9), 1e-10);
  EXPECT_GT(worst_in_wedge(quadrature::wedge_125, 9, 10), 1e-10);
}

/// The largest error over a^i b^j ζ^k with ξ = a (1 - ζ) and η = b (1 - ζ), i and j at most `across` and k at most
/// `along`: ∫ = (∫ a^i da) (∫ b^j db) ∫ ζ^k (1 - ζ)² dζ.
template <std::size_t n>
double worst_in_pyramid(const Rule<3, n>& rule, int across, int along) {
  double error = 0;
  for (int i = 0; i <= across; ++i)
    for (int j = 0; j <= across; ++j)
      for (int k = 0; k <= along; ++k) {
        double integral = 0;
        for (const auto& [xi, weight] : rule) {
          const double w = 1 - xi[2];
          integral += weight * std::pow(xi[0] / w, i) * std::pow(xi[1] / w, j) * std::pow(xi[2], k);
        }
        const double height = 2 * factorial(k) / factorial(k + 3);
        error = std::max(error, std::abs(integral - cube_moment<2>({i, j}) * height));
      }
  return error;
}

TEST(Quadrature, Pyramids) {
  EXPECT_LT(worst_in_pyramid(quadrature::pyramid_8, 3, 3), 1e-15);
  EXPECT_LT(worst_in_pyramid(quadrature::pyramid_36, 5, 7), 1e-15);
  EXPECT_GT(worst_in_pyramid(quadrature::pyramid_36, 6, 7), 1e-6);
}

}  // namespace
}  // namespace ritz::fem
