#include "ritz/fem/element.hpp"

#include <algorithm>

#include "elements/faces.hpp"
#include "elements/hexahedra.hpp"
#include "elements/pyramids.hpp"
#include "elements/tetrahedra.hpp"
#include "elements/wedges.hpp"

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

}  // namespace ritz::fem
