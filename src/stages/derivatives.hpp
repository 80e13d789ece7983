// Modal derivatives (Eq. 15), a block at a time.
#pragma once
#include <functional>
#include <vector>

#include "ritz/stages/derivative_loads.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

/// A block of derivatives and the pairs that they belong to.
struct DerivativeBlock {
  std::vector<Pair> pairs;
  mesh::FreeRows columns;  ///< Φ_ij, rows of free degrees of freedom
};

/// What became of the pairs.
struct DerivativeCounts {
  int pairs = 0, solved = 0;
  int iterations = 0;   ///< the most that a block's solve took
  double residual = 0;  ///< the largest of all solves
  double skipped = 0;   ///< Σ of the squares of the bounds on what was not solved, scaled as `weight` says
};

struct DerivativesSource {
  const Problem& problem;
  const ModesResult& modes;     ///< all that were found, and what they were found with
  const petsc::Tall& flexible;  ///< those of them whose derivatives are wanted, ψ_1 ... ψ_K'
  int rows;                     ///< only pairs (i, j) with i among the first so many of these
};

/// Solves K Φ_ij = −(H:ψ_j) ψ_i for the pairs i ≤ j in blocks of `columns`, or less than twice that, and hands each
/// over. Free bodies: the loads are projected, and Φ is M-orthogonal to the rigid modes.
///
/// A pair is not solved while Σ (weight(pair) ‖Φ‖_M)² over all those not solved is certainly below `allowed()`². The n
/// modes found split b: their part is solved exactly, and no eigenvalue of the rest c = b − MΨΨᵀb is below λ_n where
/// the modes are certified (λ₁ where not), so that ‖Φ‖²_M ≤ Σ (ψᵢᵀb/λᵢ)² + (‖c‖_{M⁻¹}/λ_n)².
/// ‖c‖²_{M⁻¹} ≤ cᵀD⁻¹c / m, D the diagonal of M and m the smallest eigenvalue of any cell's D_e⁻¹M_e [Wathen 1987].
/// Throws NumericalError. *Collective*.
DerivativeCounts derivatives(const DerivativesSource& source, int columns, const std::function<double(Pair)>& weight,
                             const std::function<double()>& allowed,
                             const std::function<void(const DerivativeBlock&)>& take);

}  // namespace ritz::stages
