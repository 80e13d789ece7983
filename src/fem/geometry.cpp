#include "ritz/fem/geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "instantiate.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {
namespace {

/// The least of `known` and det J at the points of a rule.
template <class E>
double smallest_over(const auto& rule, const Coordinates<E>& origin_first, double known) {
  for (const auto& sample : rule) known = std::min(known, jacobian<E>(origin_first, sample.xi).determinant());
  return known;
}

}  // namespace

template <class E>
double volume(const Coordinates<E>& x) {
  const Coordinates<E> origin_first = relative<E>(x);
  double sum = 0;
  for (const auto& [xi, weight] : E::mass_rule) sum += weight * jacobian<E>(origin_first, xi).determinant();
  return sum;
}

template <class E>
double smallest_jacobian(const Coordinates<E>& x) {
  const Coordinates<E> origin_first = relative<E>(x);
  double smallest = smallest_over<E>(E::rule, origin_first, std::numeric_limits<double>::infinity());
  for (int corner = 0; corner < shape(E::type).corners; ++corner)
    smallest = std::min(smallest, jacobian<E>(origin_first, E::reference[corner]).determinant());
  return smallest;
}

template <class E>
double smallest_integrated_jacobian(const Coordinates<E>& x) {
  const Coordinates<E> origin_first = relative<E>(x);
  return smallest_over<E>(E::mass_rule, origin_first,
                          smallest_over<E>(E::rule, origin_first, std::numeric_limits<double>::infinity()));
}

template <class E>
bool turned_inside_out(const Coordinates<E>& x, const Coordinates<E>& u) {
  const Coordinates<E> origin_first = relative<E>(x), relative_u = relative<E>(u);
  return std::any_of(E::rule.begin(), E::rule.end(), [&](const auto& sample) {
    const Matrix<3, 3> G = relative_u * physical_gradients<E>(origin_first, sample).gradients;
    return (Matrix<3, 3>::Identity() + G).determinant() <= 0;
  });
}

template <class E>
double shortest_edge(const Coordinates<E>& x) {
  constexpr CellShape cell = shape(E::type);
  constexpr int corners = shape(cell.face).corners;
  double shortest = std::numeric_limits<double>::infinity();
  for (int face = 0; face < cell.faces; ++face) {
    const auto v = face_vertices(E::type, face);
    for (int i = 0; i < corners; ++i) shortest = std::min(shortest, (x.col(v[i]) - x.col(v[(i + 1) % corners])).norm());
  }
  return shortest;
}

template <class E>
requires(shape(E::type).corners == 4) double smallest_dihedral(const Coordinates<E>& x) {
  const Coordinates<E> r = relative<E>(x);
  const auto normal = [&](int face) -> Vector<3> {
    const auto v = face_vertices(E::type, face);
    return (r.col(v[1]) - r.col(v[0])).cross(r.col(v[2]) - r.col(v[0]));
  };
  const double six_volumes = std::abs(r.col(1).cross(r.col(2)).dot(r.col(3)));
  // Faces f and g share an edge; |n_f x n_g| = 6 V |edge| keeps small angles to full precision.
  constexpr int shared[6][4] = {{0, 1, 0, 1}, {0, 2, 1, 2}, {0, 3, 0, 2}, {1, 2, 1, 3}, {1, 3, 0, 3}, {2, 3, 2, 3}};
  double smallest = std::numbers::pi;
  for (const auto& [f, g, i, j] : shared)
    smallest = std::min(smallest, std::atan2(six_volumes * (r.col(j) - r.col(i)).norm(), -normal(f).dot(normal(g))));
  return smallest * 180 / std::numbers::pi;
}

#define INSTANTIATE(E)                                                              \
  template double volume<E>(const Coordinates<E>&);                                 \
  template double smallest_jacobian<E>(const Coordinates<E>&);                      \
  template double smallest_integrated_jacobian<E>(const Coordinates<E>&);           \
  template bool turned_inside_out<E>(const Coordinates<E>&, const Coordinates<E>&); \
  template double shortest_edge<E>(const Coordinates<E>&);
RITZ_ELEMENTS(INSTANTIATE)
#undef INSTANTIATE
template double smallest_dihedral<Tet4>(const Coordinates<Tet4>&);
template double smallest_dihedral<Tet10>(const Coordinates<Tet10>&);

}  // namespace ritz::fem
