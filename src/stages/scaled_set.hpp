// Eq. 18's scaled set of modes and derivatives, decomposed while it grows.
#pragma once
#include "ritz/stages/derivatives.hpp"
#include "ritz/stages/principal.hpp"

namespace ritz::stages {

/// The flexible modes that enter a basis, λ ascending.
struct EnteringModes {
  Eigen::VectorXd values;  ///< 1/s²
  petsc::Tall vectors;     ///< M-orthonormal
};

/// What it is made from; all of it must outlive the calls.
struct ScaledSource {
  const Problem& problem;
  const ModesResult& modes;  ///< all that were found
  const EnteringModes& entering;
};

/// { (λ₁/λ_j) ψ_j } ∪ { (λ₁²/(λ_i λ_j)) Φ_ij, i ≤ j } so far, ψ mass-orthonormal, Φ as Eq. 15 gives it.
struct ScaledSet {
  Principal principal;
  int modes = 0;        ///< the first so many entering modes are in it
  int derivatives = 0;  ///< and all derivatives of the first so many
  DerivativeCounts counts;
};

/// K' raised to the end of a cluster.
int whole_cluster(const Eigen::VectorXd& values, int count);

/// Adds the entering modes that the set lacks of the first `count`. *Collective*.
void add_modes(const ScaledSource& source, int count, const Cut& cut, ScaledSet& set);

/// Adds the derivatives that the set lacks of the first `count` entering modes, about `block` solved at once, each
/// block dropped once it is decomposed. Throws NumericalError. *Collective*.
void add_derivatives(const ScaledSource& source, int count, int block, const Cut& cut, const ModesProgress& progress,
                     ScaledSet& set);

}  // namespace ritz::stages
