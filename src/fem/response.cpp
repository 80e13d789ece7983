#include "ritz/fem/response.hpp"

#include "instantiate.hpp"
#include "ritz/base/simd.hpp"

namespace ritz::fem {
namespace {

/// The displacement gradients at the points of a cell.
template <class E>
std::array<Matrix<3, 3>, E::rule.size()> displacement_gradients(const IntegrationPoints<E>& points,
                                                                const Coordinates<E>& u) {
  const Coordinates<E> from_first = relative<E>(u);
  std::array<Matrix<3, 3>, E::rule.size()> G;
  for (std::size_t q = 0; q < points.size(); ++q) G[q] = from_first * points[q].gradients;
  return G;
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

template <class E>
IntegrationPoints<E> integration_points(const Coordinates<E>& x) {
  const Coordinates<E> from_first = relative<E>(x);
  IntegrationPoints<E> points;
  for (std::size_t q = 0; q < points.size(); ++q) points[q] = physical_gradients<E>(from_first, E::rule[q]);
  return points;
}

template <class E>
EnergyAndForce<E> energy_and_force(const IntegrationPoints<E>& points, const Coordinates<E>& u,
                                   const Material& material) {
  std::array<Response, E::rule.size()> responses;
  respond(material, displacement_gradients<E>(points, u), responses);
  EnergyAndForce<E> result{0, Coordinates<E>::Zero()};
  for (std::size_t q = 0; q < points.size(); ++q) {
    const auto& [gradients, weight] = points[q];
    result.energy += weight * responses[q].energy;
    result.force += weight * responses[q].stress * gradients.transpose();
  }
  return result;
}

template <class E>
void TangentSum<E>::add(const IntegrationPoints<E>& points, const Coordinates<E>& u, const Material& material,
                        double weight) {
  std::array<Moduli, E::rule.size()> moduli;
  linearise(material, displacement_gradients<E>(points, u), moduli);
  for (std::size_t q = 0; q < points.size(); ++q)
    add_point(E::vertices, points[q].gradients.data(), weight * points[q].weight, moduli[q].data(), columns_.data());
}

template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> TangentSum<E>::matrix() const {
  Matrix<3 * E::vertices, 3 * E::vertices> K;
  const double* from = columns_.data();
  for (int b = 0; b < E::vertices; ++b)
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < E::vertices; ++a, from += 4)
        for (int i = 0; i < 3; ++i) {
          const int row = 3 * a + i, column = 3 * b + k;
          if (row <= column) K(row, column) = K(column, row) = from[i];
        }
  return K;
}

#define INSTANTIATE(E)                                                                                                 \
  template IntegrationPoints<E> integration_points<E>(const Coordinates<E>&);                                          \
  template EnergyAndForce<E> energy_and_force<E>(const IntegrationPoints<E>&, const Coordinates<E>&, const Material&); \
  template class TangentSum<E>;
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
