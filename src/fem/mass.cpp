#include "ritz/fem/mass.hpp"

#include <limits>

#include "instantiate.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {
namespace {

/// Of a tetrahedron of mass `mass` with straight edges and vertices in their middle, kg.
MassMatrix<Tet10> straight_mass(double mass) {
  MassMatrix<Tet10> M;
  M.topLeftCorner<4, 4>().setConstant(1);
  M.bottomRightCorner<6, 6>().setConstant(16);
  M.topRightCorner<4, 6>().setConstant(-6);
  for (int a = 0; a < 4; ++a) M(a, a) = 6;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = Tet10::edges[e];
    M(i, 4 + e) = M(j, 4 + e) = -4;
    M(4 + e, 4 + e) = 32;
    for (int f = 0; f < 6; ++f) {
      const auto [k, l] = Tet10::edges[f];
      if (i != k && i != l && j != k && j != l) M(4 + e, 4 + f) = 8;
    }
  }
  M.bottomLeftCorner<6, 4>() = M.topRightCorner<4, 6>().transpose();
  return M * (mass / 420);
}

}  // namespace

template <class E>
MassMatrix<E> mass_by_quadrature(const Coordinates<E>& x, double density) {
  const Coordinates<E> origin_first = relative<E>(x);
  MassMatrix<E> M = MassMatrix<E>::Zero();
  for (const auto& [xi, weight] : E::mass_rule) {
    const Vector<E::vertices> N = E::shape(xi);
    const double m = density * weight * jacobian<E>(origin_first, xi).determinant();
    for (int b = 0; b < E::vertices; ++b) M.col(b) += (m * N[b]) * N;
  }
  M.template triangularView<Eigen::StrictlyLower>() = M.transpose();
  return M;
}

bool straight(const Coordinates<Tet10>& x) {
  const Coordinates<Tet10> r = relative<Tet10>(x);
  const double tolerance = 8 * std::numeric_limits<double>::epsilon() * r.leftCols<4>().cwiseAbs().maxCoeff();
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = Tet10::edges[e];
    if (((r.col(i) + r.col(j)) / 2 - r.col(4 + e)).cwiseAbs().maxCoeff() > tolerance) return false;
  }
  return true;
}

template <class E>
MassMatrix<E> mass(const Coordinates<E>& x, double density) {
  if constexpr (E::type == CellType::tet4) {
    const double total = density * jacobian<E>(relative<E>(x), {}).determinant() / 6;
    return (MassMatrix<E>::Ones() + MassMatrix<E>::Identity()) * (total / 20);
  } else if constexpr (E::type == CellType::tet10) {
    if (!straight(x)) return mass_by_quadrature<E>(x, density);
    return straight_mass(density * jacobian<Tet4>(relative<Tet10>(x).template leftCols<4>(), {}).determinant() / 6);
  } else {
    return mass_by_quadrature<E>(x, density);
  }
}

#define INSTANTIATE(E)                                                         \
  template MassMatrix<E> mass_by_quadrature<E>(const Coordinates<E>&, double); \
  template MassMatrix<E> mass<E>(const Coordinates<E>&, double);
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE

}  // namespace ritz::fem
