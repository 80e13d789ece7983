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
    EXPECT_LT(worst(rule, k, total_degree<d>, simplex_moment<d>), 1e-16) << "degree " << k;
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
  expect_simplex_degree(quadrature::triangle_12, 6);
}

TEST(Quadrature, CubesAndSquares) {
  expect_cube_degree(quadrature::cube_8, 3);
  expect_cube_degree(quadrature::cube_27, 5);
  expect_cube_degree(quadrature::square_9, 5);
}

}  // namespace
}  // namespace ritz::fem
