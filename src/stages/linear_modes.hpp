// The lowest vibration modes of Kψ = λMψ (Eq. 1 of the notes), certified.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ritz/algebra/factorization.hpp"
#include "ritz/model/model.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/inverse.hpp"

namespace ritz::stages {

/// Eigenpairs computed beyond the last wanted one, to find a gap for the shift of the certificate.
inline constexpr int spare_pairs = 4;

enum class Strategy { direct, iterative };

/// `kept`: later stages solve with K as the modes did; counting the modes then needs a second factorization. `spent`:
/// the factorization may be overwritten.
enum class InverseUse { spent, kept };

struct ModesOptions {
  int count = 20;  ///< number of flexible modes wanted
  Strategy strategy = Strategy::direct;
  bool slepc = false;  ///< direct strategy: SLEPc's Krylov-Schur instead of block Lanczos
  int block = 4;
  double tolerance = 1e-10;
  InverseUse inverse = InverseUse::spent;
};

struct ModesResult {
  model::Modes modes;
  mesh::FreeRows vectors;  ///< rows of free degrees of freedom, one column for each mode
  Strategy strategy = Strategy::direct;
  int iterations = 0;
  Inverse inverse;                 ///< empty if it was spent
  mesh::FreeRows answers;          ///< static_answers to the loads that were given
  std::vector<std::string> notes;  ///< warnings, one sentence each
};

/// The rigid modes, which are the first columns.
inline algebra::ConstTallRef rigid_modes(const ModesResult& result) {
  return result.vectors.leftCols(std::ranges::count(result.modes.kinds, model::ModeKind::rigid));
}

/// The flexible modes, which follow the rigid ones, λ ascending.
inline algebra::ConstTallRef flexible_modes(const ModesResult& result) {
  return result.vectors.rightCols(result.vectors.cols() - rigid_modes(result).cols());
}

using ModesProgress = std::function<void(const std::string& what, double fraction)>;

/// *Collective*. Returns all rigid modes and at least `count` flexible ones: a cluster (relative gap under 1e-6) is
/// kept whole, and there may be fewer modes. They are M-orthonormal; signs, and bases of clusters, are determined by
/// the vertex numbers of the file.
///
/// direct: shift-invert with MUMPS and block Lanczos. Then the inertia of K − σM counts the eigenvalues below a shift σ
/// beyond the last mode; if the count disagrees, missing modes are searched for, and a difference that remains is a
/// NumericalError. iterative: LOBPCG with GAMG, which uses the rigid motions as near-null space; not certified.
/// `earlier`: modes from an earlier run of the same problem, or no columns. `loads`: loads, N, or no columns; their
/// static answers are solved for with what finds the modes, before it is spent. Throws NumericalError when fewer modes
/// converge than requested, when a residual exceeds its bound, or when ΨᵀMΨ differs from I by more than 1e-12.
ModesResult linear_modes(const Problem& problem, const ModesOptions& options, mesh::FreeRef earlier,
                         mesh::FreeRef loads, const ModesProgress& progress);

}  // namespace ritz::stages
