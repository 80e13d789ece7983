// Locally optimal block preconditioned conjugate gradients: the lowest modes without a factorization.
#pragma once
#include <functional>

#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {

struct LobpcgOptions {
  int wanted = 20;        ///< number of pairs wanted
  double fraction = 0.3;  ///< of its bound that each residual has to reach
  int iterations = 500;   ///< at most
  int patience = 40;      ///< iterations without progress after which the search stops
};

struct LobpcgResult {
  RitzPairs pairs;  ///< the wanted pairs, or all that the space contains
  int iterations = 0;
  int converged = 0;  ///< number of wanted pairs, from the lowest, whose residuals meet their bounds
};

/// z ≈ K⁻¹ r for a block of columns, symmetric and positive definite.
using BlockPreconditioner = std::function<void(const algebra::ConstTallRef& r, algebra::TallRef z)>;

/// Called after each iteration with the number of wanted pairs that have converged.
using LobpcgProgress = std::function<void(int converged, int wanted)>;

/// *Collective*. The smallest λ of Kψ = λMψ on the M-complement of the M-orthonormal columns `locked`. Each iteration
/// minimises over the iterates X, their preconditioned residuals W and the last directions P, all M-orthonormal; P is
/// made orthogonal to X in coefficients [Knyazev 2001; Hetmaniuk, Lehoucq 2006]. The block is as wide as `start`, which
/// has more columns than are wanted, to guard against missed modes. Pairs that meet their bound are not improved
/// further. `norm_K` is ‖K‖₁.
LobpcgResult lobpcg(const algebra::Matrix& K, const algebra::Matrix& M, double norm_K,
                    const BlockPreconditioner& precondition, const algebra::ConstTallRef& locked,
                    const algebra::ConstTallRef& start, const LobpcgOptions& options, const LobpcgProgress& progress);

}  // namespace ritz::stages
