// The basis U: scaled mass-PCA of modes and derivatives (Eqs. 17, 18), or POD of snapshots (Eq. 12), or both.
#pragma once
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/scaled_set.hpp"

namespace ritz::stages {

struct BasisOptions {
  std::vector<int> modes;  ///< flexible modes that enter, from 1, ascending; empty: all
  int derivatives = 0;     ///< K': of the first so many modes that enter; a cluster there is kept whole
  Cut cut;
  int block = 48;  ///< derivatives solved at once, about
};

struct BasisResult {
  mesh::FreeRows U;  ///< rows of free degrees of freedom: UᵀMU = I, UᵀKU diagonal and ascending
  model::Reduction reduction;
  DerivativeCounts derivatives;  ///< that the set was made with
  double orthonormality = 0;     ///< max |UᵀMU − I|
};

/// The flexible modes of these numbers. Throws InputError where there are fewer.
EnteringModes entering_modes(const ModesResult& modes, const std::vector<int>& chosen);

/// Eq. 18's set { (λ₁/λ_j) ψ_j } ∪ { (λ₁²/(λ_i λ_j)) Φ_ij, i ≤ j }, ψ mass-orthonormal, Φ as Eq. 15 gives it, in
/// whose M-norm singular value decomposition the first directions span U; with `snapshots` (full displacements, rows of
/// free degrees of freedom, m) these as well: alone as they are, beside modes divided by the largest M-norm of one.
/// U is turned so that UᵀKU is diagonal; signs come from vertex numbers. It has no rigid modes in it.
///
/// Derivatives are streamed: a block enters the decomposition and is dropped; `reduction.discarded` bounds all that U
/// leaves out, what was never solved included. Throws InputError when the set has fewer independent directions than the
/// cut asks for, NumericalError when a solve fails. *Collective*.
BasisResult basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef snapshots,
                  const BasisOptions& options, const ModesProgress& progress);

/// The set's directions, those of equal σ turned as make_canonical does: a cut between them takes the same on any
/// number of ranks. *Collective*.
mesh::FreeRows canonical_directions(const Problem& problem, const Principal& set);

/// The basis of the first `columns` of them, finished as above. *Collective*.
BasisResult cut_basis(const Problem& problem, const ModesResult& modes, const ScaledSet& set, int columns);

}  // namespace ritz::stages
