#include "ritz/fem/response.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "ritz/base/simd.hpp"

namespace ritz::fem {
namespace {

constexpr std::size_t most_points = 27;

/// The displacement gradient G_ij = Σ_a u_ai dN_a/dx_j of a cell of n vertices, column by column.
RITZ_WIDE void displacement_gradient(int n, const double* u, const double* gradients, double* G) {
  double sum[9] = {};
  for (int a = 0; a < n; ++a)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) sum[i + 3 * j] += u[3 * a + i] * gradients[a + n * j];
  std::copy_n(sum, 9, G);
}

/// The displacement gradients at all points.
struct DisplacementGradients {
  std::array<Matrix<3, 3>, most_points> storage;
  std::span<const Matrix<3, 3>> at;

  DisplacementGradients(const IntegrationPoints& points, const CellVectors& u)
      : at(std::span(storage).first(static_cast<std::size_t>(points.count()))) {
    const CellVectors from_first = relative(u);
    for (int q = 0; q < points.count(); ++q)
      displacement_gradient(points.vertices(), from_first.data(), points.data(q),
                            storage[static_cast<std::size_t>(q)].data());
  }
};

/// Adds weight P ∇N_a, component i of vertex a at i n + a.
RITZ_WIDE void add_force(int n, const double* gradients, double weight, const double* P, double* force) {
  for (int i = 0; i < 3; ++i) {
    const double x = weight * P[i], y = weight * P[i + 3], z = weight * P[i + 6];
    for (int a = 0; a < n; ++a) force[i * n + a] += x * gradients[a] + y * gradients[a + n] + z * gradients[a + 2 * n];
  }
}

/// Adds what one point gives to the tangent of a cell of n vertices. `gradients` is n x 3, and `columns` is laid out as
/// TangentSum's. First the change of P by the displacement of each vertex b, then the force of it on each vertex a.
RITZ_WIDE void add_point(int n, const double* gradients, double weight, const double* moduli, double* columns) {
  const double *x = gradients, *y = x + n, *z = y + n;
  const Pack<double>* A = packs(moduli);
  Pack<double>* K = packs(columns);
  for (int b = 0; b < n; ++b, K += 3 * n) {
    const double wx = weight * x[b], wy = weight * y[b], wz = weight * z[b];
    Pack<double> change[9];  // of column j of P by component k of the displacement: number 3k + j
    for (int m = 0; m < 9; ++m) change[m] = wx * A[m] + wy * A[9 + m] + wz * A[18 + m];
    for (int a = 0; a <= b; ++a)
      for (int k = 0; k < 3; ++k)
        K[k * n + a] += x[a] * change[3 * k] + y[a] * change[3 * k + 1] + z[a] * change[3 * k + 2];
  }
}

}  // namespace

EnergyAndForce energy_and_force(const IntegrationPoints& points, const CellVectors& u, const Material& material) {
  const DisplacementGradients G(points, u);
  std::array<Response, most_points> responses;
  respond(material, G.at, std::span(responses).first(G.at.size()));
  const int n = points.vertices();
  double energy = 0;
  std::array<double, 3 * max_cell_vertices> force;
  std::fill_n(force.data(), 3 * n, 0.0);
  for (int q = 0; q < points.count(); ++q) {
    const auto& response = responses[static_cast<std::size_t>(q)];
    energy += points.weight(q) * response.energy;
    add_force(n, points.data(q), points.weight(q), response.stress.data(), force.data());
  }
  return {energy, Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>>(force.data(), n, 3).transpose()};
}

TangentSum::TangentSum(const IntegrationPoints& points) : points_(points) {
  std::fill_n(columns_.data(), 12 * points.vertices() * points.vertices(), 0.0);
}

void TangentSum::add(const CellVectors& u, const Material& material, double weight) {
  const DisplacementGradients G(points_, u);
  std::array<Moduli, most_points> moduli;
  linearise(material, G.at, std::span(moduli).first(G.at.size()));
  for (int q = 0; q < points_.count(); ++q)
    add_point(points_.vertices(), points_.data(q), weight * points_.weight(q),
              moduli[static_cast<std::size_t>(q)].data(), columns_.data());
}

CellMatrix TangentSum::matrix() const {
  const int n = points_.vertices();
  CellMatrix K(3 * n, 3 * n);
  const double* from = columns_.data();
  for (int b = 0; b < n; ++b)
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < n; ++a, from += 4)
        for (int i = 0; i < 3; ++i) {
          const int row = 3 * a + i, column = 3 * b + k;
          if (row <= column) K(row, column) = K(column, row) = from[i];
        }
  return K;
}

}  // namespace ritz::fem
