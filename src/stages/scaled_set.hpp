// The scaled set of modes and derivatives of Eq. 18, decomposed while it grows.
#pragma once
#include "ritz/stages/derivatives.hpp"
#include "ritz/stages/principal.hpp"

namespace ritz::stages {

/// The flexible modes that enter a basis, λ ascending.
struct EnteringModes {
  Eigen::VectorXd values;  ///< 1/s²
  algebra::Tall vectors;   ///< M-orthonormal
};

/// The data that the set is made from; it must outlive the calls.
struct ScaledSource {
  const Problem& problem;
  const ModesResult& modes;  ///< all modes that were found
  const EnteringModes& entering;
  const algebra::Tall&
      given;  ///< M-orthonormal columns that the basis has anyhow, or none: the set is M-orthogonal to them
};

/// The part of { (λ₁/λ_j) ψ_j } ∪ { (λ₁²/(λ_i λ_j)) Φ_ij, i ≤ j } that was added so far, with ψ mass-orthonormal and Φ
/// from Eq. 15, each less its share in the given columns.
struct ScaledSet {
  Principal principal;
  int modes = 0;        ///< how many of the entering modes it contains
  int derivatives = 0;  ///< it contains all derivatives of the first so many entering modes
  DerivativeCounts counts;
};

/// *Collective*. Adds to the set what vectors have besides the M-orthonormal columns `given`.
void add_besides(const algebra::Matrix& M, const algebra::ConstTallRef& given, algebra::Tall vectors, const Cut& cut,
                 Principal& set);

/// `count`, raised to the end of the cluster that it would split.
int whole_cluster(const Eigen::VectorXd& values, int count);

/// *Collective*. Adds those of the first `count` entering modes that the set does not contain yet.
void add_modes(const ScaledSource& source, int count, const Cut& cut, ScaledSet& set);

/// *Collective*. Adds those derivatives of the first `count` entering modes that the set does not contain yet. About
/// `block` are solved at once, and discarded after they are decomposed. Throws NumericalError when a solve fails.
void add_derivatives(const ScaledSource& source, int count, int block, const Cut& cut, const ModesProgress& progress,
                     ScaledSet& set);

}  // namespace ritz::stages
