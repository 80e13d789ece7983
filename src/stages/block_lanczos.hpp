// Block Lanczos with full orthogonalisation and thick restarts, for the symmetric operator of shift-invert.
#pragma once
#include <functional>

#include "ritz/algebra/multivector.hpp"

namespace ritz::stages {

struct LanczosOptions {
  int wanted = 20;           ///< number of pairs wanted, those with the largest θ
  int spare = 0;             ///< further pairs, which need not meet the tolerance, but have values to ten digits
  int block = 4;             ///< right-hand sides of a step; the largest multiplicity that exact arithmetic would find
  int columns = 0;           ///< of the Krylov basis before a restart; 0: lanczos_columns
  double tolerance = 1e-10;  ///< bound of ‖Op y − θ y‖_M / θ
  int restarts = 100;
};

struct LanczosResult {
  Eigen::VectorXd theta;      ///< descending
  algebra::Tall vectors;      ///< M-orthonormal
  Eigen::Index accurate = 0;  ///< of these pairs the first so many meet the tolerance
  int iterations = 0;         ///< block steps
  bool converged = false;     ///< all pairs are as wanted, or the whole space was searched
};

/// y = Op x for a block of columns, given mx = M x.
using Operator = std::function<void(const algebra::ConstTallRef& mx, algebra::TallRef y)>;

/// Called after each block step with the number of wanted pairs that have converged.
using Progress = std::function<void(int converged, int wanted)>;

/// The columns of the Krylov basis before a restart, for so many pairs, spare ones too.
int lanczos_columns(int pairs, int block);

/// *Collective*. The largest eigenvalues θ of Op, which is self-adjoint in the M inner product, on the M-complement of
/// the M-orthonormal columns `locked`. For Op = (K − σM)⁻¹M with σ below the spectrum they give the smallest λ = σ +
/// 1/θ. `start` has the columns of the first block; further columns are used in turn. A cluster (relative gaps under
/// 1e-5) at the end of the wanted pairs is wanted as a whole. After the three-term recurrence each block is made
/// orthogonal to all others, which prevents spurious copies of eigenvalues; a block that lost rank is refilled.
/// [Grimes, Lewis, Simon 1994; Wu, Simon 2000].
LanczosResult block_lanczos(const algebra::Matrix& M, const Operator& op, const algebra::ConstTallRef& locked,
                            const algebra::ConstTallRef& start, const LanczosOptions& options,
                            const Progress& progress);

}  // namespace ritz::stages
