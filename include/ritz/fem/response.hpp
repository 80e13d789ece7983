// The stored energy, internal force and tangent stiffness of one cell, at any displacement and for any law.
#pragma once
#include <array>

#include "ritz/fem/material.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {

/// The shape functions' gradients and the weights at the points of the element's rule.
template <class E>
using IntegrationPoints = std::array<PhysicalGradients<E>, E::rule.size()>;

/// Those of a cell with vertices `x` at rest, 3 x vertices, m.
template <class E>
IntegrationPoints<E> integration_points(const Coordinates<E>& x);

template <class E>
struct EnergyAndForce {
  double energy;         ///< ∫ W, J
  Coordinates<E> force;  ///< 3 x vertices, N: column a is f_a = ∫ P ∇N_a = dE/du_a, which holds the cell in this shape
};

/// The energy and the internal force of a cell with the displacements `u` of its vertices, 3 x vertices, m. NaN where
/// the law does not admit the state. Allocates nothing.
template <class E>
EnergyAndForce<E> energy_and_force(const IntegrationPoints<E>& points, const Coordinates<E>& u,
                                   const Material& material);

/// A weighted sum of tangent stiffnesses of a cell, of as many states as are added. Allocates nothing.
///
/// The tangent stiffness is d(force)/du, N/m, symmetric but not always definite. Row 3a + i is component i of vertex a:
/// K_ai,bk = ∫ Σ_jl ∇N_a,j (∂P_ij/∂F_kl) ∇N_b,l. At u = 0 it equals stiffness().
template <class E>
class TangentSum {
 public:
  /// Adds weight K(u), with u 3 x vertices, m.
  void add(const IntegrationPoints<E>& points, const Coordinates<E>& u, const Material& material, double weight);
  Matrix<3 * E::vertices, 3 * E::vertices> matrix() const;

 private:
  /// For each vertex b, component k and vertex a <= b: three numbers, one a component of a, and one of padding.
  alignas(32) std::array<double, 12 * E::vertices * E::vertices> columns_{};
};

/// The tangent stiffness of one state.
template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> tangent(const IntegrationPoints<E>& points, const Coordinates<E>& u,
                                                 const Material& material) {
  TangentSum<E> sum;
  sum.add(points, u, material, 1);
  return sum.matrix();
}

}  // namespace ritz::fem
