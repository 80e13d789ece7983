// Modal derivatives (Eq. 15 of the notes): their right-hand sides, and their solves in blocks.
#pragma once
#include <functional>
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/linear_modes.hpp"

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

/// A block of derivatives and their pairs of modes.
struct DerivativeBlock {
  std::vector<Pair> pairs;
  mesh::FreeRows columns;  ///< Φ_ij, one column for each pair, rows of free degrees of freedom
};

/// How many pairs were solved, and how well.
struct DerivativeCounts {
  int pairs = 0, solved = 0;
  int iterations = 0;   ///< the largest number that the solve of a block took
  double residual = 0;  ///< the largest relative residual of all solves
  double skipped = 0;   ///< Σ of the squared bounds of the derivatives that were not solved for, times weight²
};

struct DerivativesSource {
  const Problem& problem;
  const ModesResult& modes;       ///< all modes that were found, and the inverse that found them
  const algebra::Tall& flexible;  ///< the modes whose derivatives are wanted, ψ_1 ... ψ_K'
  int rows;                       ///< only pairs (i, j) with i among the first `rows` of these
};

/// *Collective*. Solves K Φ_ij = −(H:ψ_j) ψ_i for the pairs i ≤ j, in blocks of at least `columns` and less than twice
/// as many columns, and passes each block to `take`. For free bodies the loads are projected, and Φ is M-orthogonal to
/// the rigid modes.
///
/// Pairs are skipped as long as Σ (weight(pair) ‖Φ‖_M)² over all skipped pairs is certainly below `allowed()`². ‖Φ‖_M
/// is bounded as follows. The n modes found split the load b: their part is solved exactly, and for the rest
/// c = b − MΨΨᵀb no eigenvalue is below λ_n if the modes are certified (else λ₁ is used), so that
///   ‖Φ‖²_M ≤ Σ (ψᵢᵀb/λᵢ)² + (‖c‖_{M⁻¹}/λ_n)²,  ‖c‖²_{M⁻¹} ≤ cᵀD⁻¹c / m,
/// where D is the diagonal of M and m the smallest eigenvalue of any cell's D_e⁻¹M_e [Wathen 1987].
/// Throws NumericalError when a solve does not converge.
DerivativeCounts derivatives(const DerivativesSource& source, int columns, const std::function<double(Pair)>& weight,
                             const std::function<double()>& allowed,
                             const std::function<void(const DerivativeBlock&)>& take);

}  // namespace ritz::stages
