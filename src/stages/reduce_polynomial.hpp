// The reduced energy of bodies with S = C : E (St. Venant-Kirchhoff, isotropic or not) as a polynomial (Sec. 3.1 of the
// notes).
#pragma once
#include <optional>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// The largest number of coordinates r of a polynomial: its quartic part then has 22 million coefficients.
inline constexpr int most_coordinates = 150;

/// The laws of a polynomial, one for each region, by their constants at rest: S = C : E between the second
/// Piola-Kirchhoff stress and the Green-Lagrange strain. Constants of third order do not enter.
using PolynomialLaws = std::vector<fem::ElasticConstants>;

/// The constants at rest of all regions, whatever their laws.
PolynomialLaws laws_at_rest(const fem::Materials& materials);

/// The laws of all regions; nothing if the force of one of them is not a polynomial.
std::optional<PolynomialLaws> polynomial_laws(const fem::Materials& materials);

/// *Collective*. All coefficients, exact for the quadrature rules of the elements. `u` is the basis over owned
/// vertices, 3 rows for each.
///
/// At a quadrature point the strain is E = Σ z_i sym(G_i) + Σ_{i≤j} z_i z_j Q_ij, where G_i is the displacement
/// gradient of column i, Q_ij = sym(G_iᵀG_j) and Q_ii = ½ G_iᵀG_i: it is linear in y = [z; (z_i z_j)_{i≤j}]. The energy
/// is ½ yᵀ G y. G is a sum of outer products, six for each point, accumulated by `dsyrk`, then symmetrised, and summed
/// once over the ranks.
model::Polynomial reduce_polynomial(const Problem& problem, const PolynomialLaws& laws, mesh::VertexRef u);

}  // namespace ritz::stages
