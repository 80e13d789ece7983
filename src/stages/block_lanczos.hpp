// Block Lanczos with full orthogonalisation and thick restart, for the symmetric operator of shift-invert.
#pragma once
#include <functional>

#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

struct LanczosOptions {
  int wanted = 20;           ///< pairs with the largest θ
  int block = 4;             ///< right-hand sides a step: at least the multiplicity that exact arithmetic would find
  int columns = 0;           ///< of the basis before a restart; 0: chosen from `wanted`
  double tolerance = 1e-10;  ///< ‖Op y − θ y‖_M / θ
  int restarts = 100;
};

struct LanczosResult {
  Eigen::VectorXd theta;   ///< descending
  petsc::Tall vectors;     ///< M-orthonormal
  int iterations = 0;      ///< block steps
  bool converged = false;  ///< all the wanted ones, or the whole space
};

/// y = Op x for a block of columns; `mx` is M x.
using Operator = std::function<void(const petsc::ConstTallRef& mx, petsc::TallRef y)>;

/// Called once a block step with how many of the wanted pairs have converged.
using Progress = std::function<void(int converged, int wanted)>;

/// The largest eigenvalues θ of Op (self-adjoint in the M inner product) on the M-complement of the M-orthonormal
/// columns `locked`; for Op = (K − σM)⁻¹M with σ below the spectrum these are the smallest λ = σ + 1/θ.
/// `start`: the first block's columns (any number of extra ones are used in turn). Full two-pass orthogonalisation, so
/// no ghosts; a block that lost rank is refilled. [Grimes, Lewis, Simon 1994; Wu, Simon 2000]. *Collective*.
LanczosResult block_lanczos(Mat M, const Operator& op, const petsc::ConstTallRef& locked,
                            const petsc::ConstTallRef& start, const LanczosOptions& options, const Progress& progress);

}  // namespace ritz::stages
