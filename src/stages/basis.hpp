// The basis U: mass-PCA of scaled modes and modal derivatives (Eqs. 17, 18 of the notes), or POD of snapshots (Eq. 12),
// or both.
#pragma once
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"
#include "ritz/stages/scaled_set.hpp"

namespace ritz::stages {

struct BasisOptions {
  std::vector<int> modes;  ///< numbers of the flexible modes that enter, from 1, ascending; empty: all
  int derivatives = 0;     ///< K': derivatives of the first K' modes that enter; K' is raised to the end of a cluster
  Cut cut;
  int block = 48;  ///< about how many derivatives are solved at once
};

struct BasisResult {
  mesh::FreeRows U;  ///< rows of free degrees of freedom; UᵀMU = I, UᵀKU diagonal and ascending
  model::Reduction reduction;
  DerivativeCounts derivatives;  ///< of the derivatives in the set
  double orthonormality = 0;     ///< max |UᵀMU − I|
};

/// The flexible modes with these numbers, from 1. Throws InputError when there are fewer.
EnteringModes entering_modes(const ModesResult& modes, const std::vector<int>& chosen);

/// *Collective*. U spans the first directions of a singular value decomposition, in the M-norm, of the set of Eq. 18, {
/// (λ₁/λ_j) ψ_j } ∪ { (λ₁²/(λ_i λ_j)) Φ_ij, i ≤ j }, with ψ mass-orthonormal and Φ from Eq. 15. `snapshots` (full
/// displacements, rows of free degrees of freedom, m) are added to the set: unscaled if they are alone, and divided by
/// the largest of their M-norms beside modes. U is rotated so that UᵀKU is diagonal; its signs come from vertex
/// numbers. It contains no rigid modes.
///
/// U also spans the M-orthonormal columns `given`, such as residual vectors, which no cut leaves out: the cut is that
/// of what the set has besides them, and they come on top of its size.
///
/// Derivatives are processed in blocks: each block enters the decomposition and is discarded. `reduction.discarded`
/// bounds everything that U leaves out, including what was never solved for. Throws InputError when the set has fewer
/// independent directions than the cut asks for, and NumericalError when a solve fails.
BasisResult basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef snapshots, const algebra::Tall& given,
                  const BasisOptions& options, const ModesProgress& progress);

/// *Collective*. The basis of a linear model with residual vectors: all modes as they are, with their eigenvalues as
/// stiffness, and the residual vectors against them, by ascending stiffness. No singular values belong to it. Throws
/// NumericalError when they are not orthonormal.
BasisResult joined_basis(const Problem& problem, const ModesResult& modes, const RitzPairs& residual);

/// *Collective*. The directions of the set. Those with equal σ are rotated as make_canonical does, so that a cut
/// between them gives the same basis on any number of ranks.
mesh::FreeRows canonical_directions(const Problem& problem, const Principal& set);

/// *Collective*. The basis of the columns `given` and the first `columns` directions of the set beside them, finished
/// as in basis().
BasisResult cut_basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef given, const ScaledSet& set,
                      int columns);

}  // namespace ritz::stages
