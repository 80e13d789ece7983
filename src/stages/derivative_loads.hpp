// Right-hand sides of the modal derivatives.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// The pair of modes (i, j), i ≤ j, 0-based.
struct Pair {
  int i, j;
};

/// All pairs (i, j) with i in [first, last) and i ≤ j < modes, ordered by i, then j.
std::vector<Pair> pairs_of_rows(int first, int last, int modes);

/// b_ij = −(H:ψ_j) ψ_i of Eq. 15 for all pairs with i in [first, last), N, one column for each pair, rows of free
/// degrees of freedom. H is the second derivative of the internal force at rest. With ∇ψ_i = G_i, e_i = sym(G_i) and
/// S(X) = λ tr(X) I + 2μ sym(X), the share of a cell, by the element's rule, is
///   −∫ [S(G_iᵀG_j) + G_i S(G_j) + G_j S(G_i) + T(e_i, e_j)] ∇N_a,
///   T(e, h) = A (eh + he) + 2B (tr(e) h + tr(h) e + e : h I) + 2C tr(e) tr(h) I,
/// where T has the law's constants of third order and is zero for St. Venant-Kirchhoff.
///
/// `local` are the modes over all local vertices (mesh::with_ghosts), 3 rows for each. Each rank computes the complete
/// rows of its own vertices; nothing is communicated.
mesh::FreeRows derivative_loads(const Problem& problem, mesh::LocalRef local, int first, int last);

}  // namespace ritz::stages
