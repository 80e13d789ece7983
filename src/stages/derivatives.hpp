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
  petsc::Tall columns;  ///< Φ_ij, rows of free degrees of freedom
};

/// What became of the pairs.
struct DerivativeCounts {
  int pairs = 0, solved = 0;
  int iterations = 0;    ///< the most that a block's solve took
  double residual = 0;   ///< the largest of all solves
  double skipped = 0;    ///< Σ of the squares of the bounds on what was not solved, scaled as `weight` says
};

struct DerivativesSource {
  const mesh::Mesh& mesh;
  const mesh::Dofs& dofs;
  const Full& full;
  const petsc::Tall& rigid;       ///< M-orthonormal
  const petsc::Tall& flexible;    ///< the modes ψ_1 ... ψ_K'
  const Inverse& inverse;
};

/// Solves K Φ_ij = −(H:ψ_j) ψ_i for all pairs i ≤ j in blocks of `columns` or a little more and hands each block over.
/// Free bodies: the loads are projected, and Φ is M-orthogonal to the rigid modes.
///
/// A pair is not solved when weight(pair) ‖Φ‖_M is certainly below `least()`, by ‖Φ‖_M ≤ ‖b‖_{M⁻¹}/λ₁ and
/// ‖b‖²_{M⁻¹} ≤ bᵀ D⁻¹ b / c, D the diagonal of M and c the smallest eigenvalue of any cell's D_e⁻¹M_e [Wathen 1987].
/// Pairs of the first `always` modes are always solved. Throws NumericalError. *Collective*.
DerivativeCounts derivatives(const DerivativesSource& source, double first_eigenvalue, int columns, int always,
                             const std::function<double(Pair)>& weight, const std::function<double()>& least,
                             const std::function<void(const DerivativeBlock&)>& take);

}  // namespace ritz::stages
