#include "ritz/fem/stiffness.hpp"

#include <algorithm>

#include "ritz/base/simd.hpp"
#include "ritz/fem/integration_points.hpp"

namespace ritz::fem {
namespace {

/// Adds what one point gives to P_ij = ∫ dN_a/dx_i dN_b/dx_j for a <= b, at ((3b + j) 3 + i) n + a.
RITZ_WIDE void add_outer_products(int n, double weight, const double* gradients, double* P) {
  for (int b = 0; b < n; ++b)
    for (int j = 0; j < 3; ++j) {
      const double factor = weight * gradients[b + n * j];
      for (int i = 0; i < 3; ++i, P += n)
        for (int a = 0; a <= b; ++a) P[a] += factor * gradients[a + n * i];
    }
}

}  // namespace

CellMatrix stiffness(CellType type, const CellVectors& x, const ElasticConstants& material) {
  const IntegrationPoints points(type, x);
  const int n = points.vertices();
  std::array<double, 9 * max_cell_vertices * max_cell_vertices> products;
  std::fill_n(products.data(), 9 * n * n, 0.0);
  for (int q = 0; q < points.count(); ++q) add_outer_products(n, points.weight(q), points.data(q), products.data());

  const double lambda = material.lambda, mu = material.mu;
  CellMatrix K(3 * n, 3 * n);
  for (int b = 0; b < n; ++b)
    for (int a = 0; a <= b; ++a) {
      const double* from = products.data() + 9 * n * b + a;
      const auto P = [&](int i, int j) { return from[(3 * j + i) * n]; };
      const double trace = mu * (P(0, 0) + P(1, 1) + P(2, 2));
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) K(3 * a + i, 3 * b + j) = lambda * P(i, j) + mu * P(j, i) + (i == j ? trace : 0);
    }
  K.triangularView<Eigen::StrictlyLower>() = K.transpose();
  return K;
}

}  // namespace ritz::fem
