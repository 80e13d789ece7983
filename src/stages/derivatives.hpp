// Modal derivatives (Eq. 15 of the notes), computed in blocks.
#pragma once
#include <functional>
#include <vector>

#include "ritz/stages/derivative_loads.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

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
