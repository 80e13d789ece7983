// The ways to find the lowest modes: our block Lanczos, SLEPc, and multigrid without a factorization.
#pragma once
#include "ritz/stages/linear_modes.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {

/// What a strategy works on.
struct EigenProblem {
  const Problem& body;
  const petsc::Tall& rigid;  ///< M-orthonormal rigid modes
  double norm_K;             ///< ‖K‖₁
};

/// Eigenpairs found, ascending, and how.
struct Found {
  RitzPairs pairs;
  int iterations = 0;
  Inverse inverse = {};
};

/// The `wanted` lowest flexible pairs (fewer only when there are no more), given some of them already. *Collective*.
Found find_direct(const EigenProblem& problem, int wanted, const petsc::Tall& known, const ModesOptions& options,
                  petsc::Factorization& solver, const ModesProgress& progress);
Found find_by_krylov_schur(const EigenProblem& problem, int wanted);
Found find_iteratively(const EigenProblem& problem, int wanted, const petsc::Tall& known,
                       const ModesProgress& progress);

/// How many columns the iterative strategy works on for so many pairs.
int iterative_block(int wanted);

/// The shift of the spectral transformation: 0 where the supports hold the body; a tenth of the first elastic
/// eigenvalue's scale below 0 where it can move rigidly. *Collective*.
double safe_shift(const EigenProblem& problem);

}  // namespace ritz::stages
