#include "ritz/fem/response.hpp"

#include <array>

#include "instantiate.hpp"

namespace ritz::fem {
namespace {

/// The quadrature points of a cell, and the displacement gradients there.
template <class E>
struct Points {
  static constexpr std::size_t count = E::rule.size();
  std::array<PhysicalGradients<E>, count> shape;
  std::array<Matrix<3, 3>, count> G;

  Points(const Coordinates<E>& x, const Coordinates<E>& u) {
    const Coordinates<E> origin_first = relative<E>(x), relative_u = relative<E>(u);
    for (std::size_t q = 0; q < count; ++q) {
      shape[q] = physical_gradients<E>(origin_first, E::rule[q]);
      G[q] = relative_u * shape[q].gradients;
    }
  }
};

}  // namespace

template <class E>
EnergyAndForce<E> energy_and_force(const Coordinates<E>& x, const Coordinates<E>& u, const Material& material) {
  const Points<E> points(x, u);
  std::array<Response, Points<E>::count> responses;
  respond(material, points.G, responses);
  EnergyAndForce<E> result{0, Coordinates<E>::Zero()};
  for (std::size_t q = 0; q < points.count; ++q) {
    const auto& [gradients, weight] = points.shape[q];
    result.energy += weight * responses[q].energy;
    result.force += weight * responses[q].stress * gradients.transpose();
  }
  return result;
}

template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const Coordinates<E>& x, const Coordinates<E>& u,
                                                 const Material& material) {
  constexpr int n = E::vertices;
  const Points<E> points(x, u);
  std::array<Moduli, Points<E>::count> moduli;
  linearise(material, points.G, moduli);
  Matrix<3 * n, 3 * n> K = Matrix<3 * n, 3 * n>::Zero();
  for (std::size_t q = 0; q < points.count; ++q) {
    const auto& [gradients, weight] = points.shape[q];
    for (int b = 0; b < n; ++b) {
      Matrix<9, 3> change = Matrix<9, 3>::Zero();  // of P, by the displacement of vertex b
      for (int l = 0; l < 3; ++l) change += weight * gradients(b, l) * moduli[q].template middleCols<3>(3 * l);
      for (int a = 0; a <= b; ++a) {
        auto block = K.template block<3, 3>(3 * a, 3 * b);
        for (int j = 0; j < 3; ++j) block += gradients(a, j) * change.template middleRows<3>(3 * j);
      }
    }
  }
  K.template triangularView<Eigen::StrictlyLower>() = K.transpose();
  return K;
}

#define INSTANTIATE(E)                                                                                           \
  template EnergyAndForce<E> energy_and_force<E>(const Coordinates<E>&, const Coordinates<E>&, const Material&); \
  template Matrix<3 * E::vertices, 3 * E::vertices> tangent<E>(const Coordinates<E>&, const Coordinates<E>&,     \
                                                               const Material&);
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
