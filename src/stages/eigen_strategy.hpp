// The methods to find the lowest modes: ritz's block Lanczos, SLEPc, and multigrid without a factorization.
#pragma once
#include "ritz/stages/linear_modes.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {

/// The eigenvalue problem that a strategy solves.
struct EigenProblem {
  const Problem& body;
  const algebra::Tall& rigid;  ///< M-orthonormal rigid modes
  double norm_K;               ///< ‖K‖₁
};

/// The eigenpairs found, λ ascending, and how.
struct Found {
  RitzPairs pairs;
  Eigen::Index accurate = 0;  ///< so many of the lowest; of the others the vectors are rough
  int iterations = 0;
  Inverse inverse = {};
};

/// *Collective*. The `wanted` lowest flexible pairs (fewer only if there are no more), of which the last `spare_pairs`
/// may be rough, unless they belong to a cluster with others. `known`: accurate pairs that are already found.
Found find_direct(const EigenProblem& problem, int wanted, const algebra::Tall& known, const ModesOptions& options,
                  algebra::Factorization& solver, const ModesProgress& progress);
Found find_by_krylov_schur(const EigenProblem& problem, int wanted);
Found find_iteratively(const EigenProblem& problem, int wanted, const algebra::Tall& known,
                       const ModesProgress& progress);

/// *Collective*. A multigrid cycle for K − σM with the safe shift σ.
Inverse multigrid_inverse(const EigenProblem& problem);

/// The block size of the iterative strategy for so many wanted pairs.
int iterative_block(int wanted);

/// *Collective*. The shift of the spectral transformation: 0 if the supports hold the body; if it can move rigidly,
/// minus a tenth of the elastic scale of its first eigenvalue.
double safe_shift(const EigenProblem& problem);

}  // namespace ritz::stages
