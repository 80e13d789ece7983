// The stored energy, internal force and tangent stiffness of one cell, at any displacement and for any law.
#pragma once
#include "ritz/fem/element.hpp"
#include "ritz/fem/material.hpp"

namespace ritz::fem {

struct EnergyAndForce {
  double energy;      ///< ∫ W, J
  CellVectors force;  ///< N: column a is f_a = ∫ P ∇N_a = dE/du_a, which holds the cell in this shape
};

/// The energy and the internal force of a cell with the displacements `u` of its vertices, 3 x vertices, m. NaN where
/// the law does not admit the state. Allocates nothing.
EnergyAndForce energy_and_force(const IntegrationPoints& points, const CellVectors& u, const Material& material);

/// A weighted sum of tangent stiffnesses of a cell, of as many states as are added. Allocates nothing.
///
/// The tangent stiffness is d(force)/du, N/m, symmetric but not always definite: K_ai,bk = ∫ Σ_jl ∇N_a,j (∂P_ij/∂F_kl)
/// ∇N_b,l. At u = 0 it equals stiffness().
class TangentSum {
 public:
  explicit TangentSum(const IntegrationPoints& points);
  /// Adds weight K(u), with u 3 x vertices, m.
  void add(const CellVectors& u, const Material& material, double weight);
  CellMatrix matrix() const;

 private:
  const IntegrationPoints& points_;
  /// For each vertex b, component k and vertex a <= b: three numbers, one a component of a, and one of padding.
  alignas(32) std::array<double, 12 * max_cell_vertices * max_cell_vertices> columns_;
};

/// The tangent stiffness of one state.
inline CellMatrix tangent(const IntegrationPoints& points, const CellVectors& u, const Material& material) {
  TangentSum sum(points);
  sum.add(u, material, 1);
  return sum.matrix();
}

}  // namespace ritz::fem
