// Right-hand sides of the modal derivatives.
#pragma once
#include <vector>

#include "ritz/petsc/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// The pair of modes (i, j), i ≤ j, 0-based.
struct Pair {
  int i, j;
};

/// All pairs (i, j), i in [first, last), i ≤ j < modes, row by row.
std::vector<Pair> pairs_of_rows(int first, int last, int modes);

/// b_ij = −(H:ψ_j) ψ_i of Eq. 15 for all pairs of these rows, N, a column each, rows of free degrees of freedom. H is
/// the second derivative of the internal force at rest: with ∇ψ_i = G_i, e_i = sym(G_i) and S(X) = λ tr(X) I + 2μ
/// sym(X), a cell's share is −∫ [S(G_iᵀG_j) + G_i S(G_j) + G_j S(G_i) + T(e_i, e_j)] ∇N_a by the element's own rule,
/// where T(e, h) = A (eh + he) + 2B (tr(e) h + tr(h) e + e : h I) + 2C tr(e) tr(h) I has the law's constants of third
/// order, zero for St. Venant-Kirchhoff.
///
/// `local`: the modes over all local vertices (mesh::with_ghosts), 3 rows a vertex. Each rank computes complete rows of
/// its own vertices: nothing is communicated.
mesh::FreeRows derivative_loads(const Problem& problem, mesh::LocalRef local, int first, int last);

}  // namespace ritz::stages
