#include "ritz/fem/element.hpp"

#include <algorithm>
#include <cassert>

#include "elements/faces.hpp"
#include "elements/hexahedra.hpp"
#include "elements/pyramids.hpp"
#include "elements/tetrahedra.hpp"
#include "elements/wedges.hpp"
#include "ritz/base/simd.hpp"

namespace ritz::fem {
namespace {

template <class E, int d>
Tabulated tabulated(std::span<const Sample<d>> samples) {
  Tabulated table;
  for (const auto& [xi, weight] : samples) {
    table.weights.push_back(weight);
    const auto N = E::shape(xi);
    table.values.insert(table.values.end(), N.begin(), N.end());
    for (const auto& column : E::gradient(xi))
      table.gradients.insert(table.gradients.end(), column.begin(), column.end());
  }
  return table;
}

template <class E>
auto made() {
  constexpr int d = static_cast<int>(E::reference[0].size());
  Element<d> element{static_cast<int>(E::reference.size()),
                     E::reference,
                     [](const Point<d>& xi, double* values) { std::ranges::copy(E::shape(xi), values); },
                     [](const Point<d>& xi, double* gradients) {
                       for (const auto& column : E::gradient(xi)) gradients = std::ranges::copy(column, gradients).out;
                     },
                     tabulated<E, d>(E::rule),
                     {},
                     {}};
  if constexpr (d == 3) {
    std::vector<Sample<d>> at_vertices;
    for (const auto& xi : E::reference) at_vertices.push_back({xi, 0});
    element.mass_rule = tabulated<E, d>(E::mass_rule);
    element.at_vertices = tabulated<E, d>(at_vertices);
  }
  return element;
}

}  // namespace

const Element<3>& element(CellType type) {  // in the order of CellType
  static const Element<3> all[] = {made<Tet4>(),   made<Tet10>(),   made<Hex8>(),    made<Hex20>(),
                                   made<Wedge6>(), made<Wedge15>(), made<Pyramid5>()};
  return all[static_cast<std::size_t>(type)];
}

const Element<2>& element(FaceType type) {
  static const Element<2> all[] = {made<Tri3>(), made<Tri6>(), made<Quad4>(), made<Quad8>()};
  return all[static_cast<std::size_t>(type)];
}

namespace {

/// One point of a cell of n vertices: its Jacobian's determinant, and the gradients with respect to x, n x 3, from
/// those with respect to the reference coordinates.
RITZ_WIDE double differentiate(int n, const double* x, const double* reference, double* gradients) {
  double J[3][3] = {};  // J[j][i] = dx_i/dξ_j
  for (int a = 0; a < n; ++a)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) J[j][i] += x[3 * a + i] * reference[a + n * j];
  double cofactor[3][3];  // of J[j][i]
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const int k = (j + 1) % 3, l = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
      cofactor[j][i] = J[k][p] * J[l][q] - J[k][q] * J[l][p];
    }
  const double determinant = J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] + J[0][2] * cofactor[0][2];
  for (int i = 0; i < 3; ++i) {
    const double r = cofactor[0][i] / determinant, s = cofactor[1][i] / determinant, t = cofactor[2][i] / determinant;
    for (int a = 0; a < n; ++a)
      gradients[a + n * i] = r * reference[a] + s * reference[a + n] + t * reference[a + 2 * n];
  }
  return determinant;
}

}  // namespace

IntegrationPoints::IntegrationPoints(const Tabulated& table, const CellVectors& x)
    : vertices_(static_cast<int>(x.cols())), count_(table.count()) {
  assert(count_ <= std::ssize(weights_) && 3 * vertices_ * count_ <= std::ssize(gradients_));
  const CellVectors from_first = relative(x);
  for (int q = 0; q < count_; ++q) {
    const auto place = 3 * vertices_ * q;
    weights_[static_cast<std::size_t>(q)] =
        table.weights[static_cast<std::size_t>(q)] *
        differentiate(vertices_, from_first.data(), table.gradients.data() + place, gradients_.data() + place);
  }
}

}  // namespace ritz::fem
