// Locally optimal block preconditioned conjugate gradients: the lowest modes without a factorization.
#pragma once
#include <functional>

#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {

struct LobpcgOptions {
  int wanted = 20;
  double fraction = 0.3;  ///< of its gate that each residual has to reach
  int iterations = 500;
  int patience = 40;  ///< iterations without progress after which the search gives up
};

struct LobpcgResult {
  RitzPairs pairs;  ///< the wanted ones, or all that the space holds
  int iterations = 0;
  int converged = 0;  ///< how many of the wanted pairs meet their gates, counted from the lowest
};

/// z ≈ K⁻¹ r for a block of columns, symmetric and positive definite.
using BlockPreconditioner = std::function<void(const petsc::ConstTallRef& r, petsc::TallRef z)>;

/// Called once an iteration with how many of the wanted pairs have converged.
using LobpcgProgress = std::function<void(int converged, int wanted)>;

/// The smallest λ of Kψ = λMψ on the M-complement of the M-orthonormal columns `locked`. Each iteration minimises over
/// the iterates X, their preconditioned residuals W and the last directions P, all M-orthonormal, with P made
/// orthogonal to X in coefficients [Knyazev 2001; Hetmaniuk, Lehoucq 2006]. The block is as wide as `start`, which has
/// more columns than are wanted: guards against a missed mode. What has met its gate is no longer improved.
/// `norm_K` is ‖K‖₁. *Collective*.
LobpcgResult lobpcg(Mat K, Mat M, double norm_K, const BlockPreconditioner& precondition,
                    const petsc::ConstTallRef& locked, const petsc::ConstTallRef& start, const LobpcgOptions& options,
                    const LobpcgProgress& progress);

}  // namespace ritz::stages
