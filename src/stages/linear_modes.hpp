// The lowest vibration modes of Kψ = λMψ (Eq. 1), certified.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/petsc/factorization.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/inverse.hpp"

namespace ritz::stages {

/// Pairs sought beyond the last wanted one, among which a gap for the certificate's shift is found.
inline constexpr int spare_pairs = 4;

enum class Strategy { direct, iterative };

/// Whether later stages solve with K as the modes did. The count of the modes then takes a second factorization.
enum class InverseUse { spent, kept };

struct ModesOptions {
  int count = 20;  ///< flexible modes wanted
  Strategy strategy = Strategy::direct;
  bool slepc = false;  ///< the direct strategy by SLEPc's Krylov-Schur in place of block Lanczos
  int block = 4;
  double tolerance = 1e-10;
  InverseUse inverse = InverseUse::spent;
};

struct ModesResult {
  model::Modes modes;
  mesh::FreeRows vectors;  ///< rows of free degrees of freedom, a column each mode
  Strategy strategy = Strategy::direct;
  int iterations = 0;
  Inverse inverse;                 ///< empty where it is spent
  std::vector<std::string> notes;  ///< what a careful user should know
};

/// The rigid modes: the first columns.
inline petsc::ConstTallRef rigid_modes(const ModesResult& result) {
  return result.vectors.leftCols(std::ranges::count(result.modes.kinds, model::ModeKind::rigid));
}

/// The flexible modes: the columns behind the rigid ones, λ ascending.
inline petsc::ConstTallRef flexible_modes(const ModesResult& result) {
  return result.vectors.rightCols(result.vectors.cols() - rigid_modes(result).cols());
}

using ModesProgress = std::function<void(const std::string& what, double fraction)>;

/// At least `count` flexible modes (a cluster, relative gap under 1e-6, is kept whole; never more than there are) and
/// all rigid ones, M-orthonormal, with signs and bases of clusters fixed by the vertices' file numbers.
///
/// direct: shift-invert with MUMPS and block Lanczos; then the inertia of K − σM counts the eigenvalues below a shift
/// past the last mode; a count that disagrees is searched for and, if it stays, a NumericalError. iterative: LOBPCG
/// with GAMG, the rigid motions its near-null space; not certified. `earlier`: modes of an earlier run of the same
/// problem, or no columns. Throws NumericalError when fewer modes converge than were asked for, a residual is above
/// its gate, or ΨᵀMΨ differs from I by more than 1e-12. *Collective*.
ModesResult linear_modes(const Problem& problem, const ModesOptions& options, mesh::FreeRef earlier,
                         const ModesProgress& progress);

}  // namespace ritz::stages
