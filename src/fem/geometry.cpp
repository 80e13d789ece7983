#include "ritz/fem/geometry.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jacobian.hpp"
#include "ritz/fem/element.hpp"

namespace ritz::fem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The least det J at the first `count` points of a table.
double smallest_over(const Tabulated& table, int count, const CellVectors& from_first) {
  double smallest = infinity;
  for (int q = 0; q < count; ++q) smallest = std::min(smallest, jacobian(table, q, from_first));
  return smallest;
}

}  // namespace

double volume(CellType type, const CellVectors& x) {
  const auto& rule = element(type).mass_rule;
  const CellVectors from_first = relative(x);
  double sum = 0;
  for (int q = 0; q < rule.count(); ++q)
    sum += rule.weights[static_cast<std::size_t>(q)] * jacobian(rule, q, from_first);
  return sum;
}

double smallest_jacobian(CellType type, const CellVectors& x) {
  const auto& of = element(type);
  const CellVectors from_first = relative(x);
  return std::min(smallest_over(of.rule, of.rule.count(), from_first),
                  smallest_over(of.at_vertices, shape(type).corners, from_first));
}

double smallest_integrated_jacobian(CellType type, const CellVectors& x) {
  const auto& of = element(type);
  const CellVectors from_first = relative(x);
  return std::min(smallest_over(of.rule, of.rule.count(), from_first),
                  smallest_over(of.mass_rule, of.mass_rule.count(), from_first));
}

bool turned_inside_out(CellType type, const CellVectors& x, const CellVectors& u) {
  const IntegrationPoints points(type, x);
  const CellVectors from_first = relative(u);
  for (int q = 0; q < points.count(); ++q) {
    const Matrix<3, 3> F = Matrix<3, 3>::Identity() + from_first.lazyProduct(points.gradients(q));
    if (F.determinant() <= 0) return true;
  }
  return false;
}

bool straight(CellType type, const CellVectors& x) {
  const CellShape cell = shape(type);
  if (!cell.quadratic()) return true;
  const CellVectors r = relative(x);
  const double tolerance = 8 * std::numeric_limits<double>::epsilon() * r.leftCols(cell.corners).cwiseAbs().maxCoeff();
  for (std::size_t e = 0; e < cell.edges.size(); ++e) {
    const auto [i, j] = cell.edges[e];
    const Vector<3> away = (r.col(i) + r.col(j)) / 2 - r.col(cell.corners + static_cast<int>(e));
    if (away.cwiseAbs().maxCoeff() > tolerance) return false;
  }
  return true;
}

double shortest_edge(CellType type, const CellVectors& x) {
  double shortest = infinity;
  for (const auto& [i, j] : shape(type).edges) shortest = std::min(shortest, (x.col(i) - x.col(j)).norm());
  return shortest;
}

double smallest_dihedral(const CellVectors& x) {
  const CellVectors r = relative(x);
  const auto normal = [&](int face) -> Vector<3> {
    const auto v = face_vertices(CellType::tet4, face);
    const Vector<3> along = r.col(v[1]) - r.col(v[0]), across = r.col(v[2]) - r.col(v[0]);
    return along.cross(across);
  };
  const Vector<3> a = r.col(1), b = r.col(2), c = r.col(3);
  const double six_volumes = std::abs(a.cross(b).dot(c));
  // Faces f and g share an edge; |n_f x n_g| = 6 V |edge| keeps small angles to full precision.
  constexpr int shared[6][4] = {{0, 1, 0, 1}, {0, 2, 1, 2}, {0, 3, 0, 2}, {1, 2, 1, 3}, {1, 3, 0, 3}, {2, 3, 2, 3}};
  double smallest = std::numbers::pi;
  for (const auto& [f, g, i, j] : shared)
    smallest = std::min(smallest, std::atan2(six_volumes * (r.col(j) - r.col(i)).norm(), -normal(f).dot(normal(g))));
  return smallest * 180 / std::numbers::pi;
}

}  // namespace ritz::fem
