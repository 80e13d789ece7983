#include "ritz/fem/cell_matrices.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "jacobian.hpp"
#include "ritz/base/simd.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/fem/geometry.hpp"

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

/// The blocks of the upper triangle: block(P) is what P = ∫ ∇N_a ∇N_bᵀ makes of vertices a and b.
template <class Block>
CellMatrix of_blocks(int n, const double* products, const Block& block) {
  CellMatrix K(3 * n, 3 * n);
  for (int b = 0; b < n; ++b)
    for (int a = 0; a <= b; ++a) {
      const double* from = products + 9 * n * b + a;
      Matrix<3, 3> P;
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) P(i, j) = from[(3 * j + i) * n];
      K.block<3, 3>(3 * a, 3 * b) = block(P);
    }
  K.triangularView<Eigen::StrictlyLower>() = K.transpose();
  return K;
}

}  // namespace

CellMatrix stiffness(CellType type, const CellVectors& x, const ElasticConstants& material) {
  const IntegrationPoints points(type, x);
  const int n = points.vertices();
  std::array<double, 9 * max_cell_vertices * max_cell_vertices> products;
  std::fill_n(products.data(), 9 * n * n, 0.0);
  for (int q = 0; q < points.count(); ++q) add_outer_products(n, points.weight(q), points.data(q), products.data());

  if (!material.moduli)
    return of_blocks(n, products.data(), [&](const Matrix<3, 3>& P) -> Matrix<3, 3> {
      Matrix<3, 3> block = material.lambda * P + material.mu * P.transpose();
      block.diagonal().array() += material.mu * P.trace();
      return block;
    });
  const Matrix<6, 6>& C = *material.moduli;
  return of_blocks(n, products.data(), [&](const Matrix<3, 3>& P) -> Matrix<3, 3> {
    Matrix<3, 3> block = Matrix<3, 3>::Zero();  // Σ_mo C_imjo P_mo
    for (int m = 0; m < 3; ++m)
      for (int o = 0; o < 3; ++o)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i) block(i, j) += C(strain_component(i, m), strain_component(j, o)) * P(m, o);
    return block;
  });
}

namespace {

/// Adds m N Nᵀ above the diagonal and on it.
RITZ_WIDE void add_outer(int n, double m, const double* N, double* M) {
  for (int b = 0; b < n; ++b)
    for (int a = 0; a <= b; ++a) M[a + n * b] += m * N[b] * N[a];
}

/// Six times the volume of a tetrahedron with straight edges.
double six_volumes(const CellVectors& x) { return relative(x).middleCols<3>(1).determinant(); }

VertexMatrix linear_tetrahedron(double mass) {
  VertexMatrix M = VertexMatrix::Ones(4, 4);
  M.diagonal().setConstant(2);
  return M * (mass / 20);
}

/// Of a tetrahedron with straight edges and vertices in their middle.
VertexMatrix straight_quadratic_tetrahedron(double mass) {
  VertexMatrix M(10, 10);
  M.topLeftCorner<4, 4>().setConstant(1);
  M.bottomRightCorner<6, 6>().setConstant(16);
  M.topRightCorner<4, 6>().setConstant(-6);
  const auto edges = shape(CellType::tet10).edges;
  for (int a = 0; a < 4; ++a) M(a, a) = 6;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = edges[e];
    const int row = 4 + static_cast<int>(e);
    M(i, row) = M(j, row) = -4;
    M(row, row) = 32;
    for (std::size_t f = 0; f < 6; ++f) {
      const auto [k, l] = edges[f];
      if (i != k && i != l && j != k && j != l) M(row, 4 + static_cast<int>(f)) = 8;
    }
  }
  M.bottomLeftCorner<6, 4>() = M.topRightCorner<4, 6>().transpose();
  return M * (mass / 420);
}

}  // namespace

VertexMatrix mass_by_quadrature(CellType type, const CellVectors& x, double density) {
  const auto& rule = element(type).mass_rule;
  const CellVectors from_first = relative(x);
  const int n = element(type).vertices;
  VertexMatrix M = VertexMatrix::Zero(n, n);
  for (int q = 0; q < rule.count(); ++q)
    add_outer(n, density * rule.weights[static_cast<std::size_t>(q)] * jacobian(rule, q, from_first),
              rule.values.data() + n * q, M.data());
  for (int b = 0; b < n; ++b)
    for (int a = 0; a < b; ++a) M(b, a) = M(a, b);
  return M;
}

VertexMatrix mass(CellType type, const CellVectors& x, double density) {
  if (type == CellType::tet4) return linear_tetrahedron(density * six_volumes(x) / 6);
  if (type == CellType::tet10 && straight(type, x)) return straight_quadratic_tetrahedron(density * six_volumes(x) / 6);
  return mass_by_quadrature(type, x, density);
}

}  // namespace ritz::fem
