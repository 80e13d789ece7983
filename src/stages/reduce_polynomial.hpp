// The reduced energy of St. Venant-Kirchhoff bodies as a polynomial (Sec. 3.1).
#pragma once
#include <optional>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// Coordinates of a polynomial: its quartic part then has 22 million numbers.
inline constexpr int most_coordinates = 150;

/// The laws that it is made for, one a region.
using PolynomialLaws = std::vector<fem::StVK>;

/// The laws of all regions; nothing where the force of one is no polynomial.
inline std::optional<PolynomialLaws> polynomial_laws(const fem::Materials& materials) {
  return fem::all_of<fem::StVK>(materials);
}

/// All coefficients, exact for the elements' own quadrature rules. `u`: the basis over owned vertices, 3 rows a vertex.
///
/// At a quadrature point the strain is E = Σ z_i sym(G_i) + Σ_{i≤j} z_i z_j Q_ij with G_i the displacement gradient of
/// column i, Q_ij = sym(G_iᵀG_j), Q_ii = ½ G_iᵀG_i: linear in y = [z; (z_i z_j)_{i≤j}]. The energy is ½ yᵀ G y, and G
/// is a sum of outer products, six a point, accumulated by `dsyrk`; then symmetrised, and summed once over the ranks.
/// *Collective*.
model::Polynomial reduce_polynomial(const Problem& problem, const PolynomialLaws& laws, mesh::VertexRef u);

}  // namespace ritz::stages
