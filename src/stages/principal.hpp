// The principal directions of a set of vectors that comes in blocks.
#pragma once
#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

/// A truncated singular value decomposition of everything added so far, in the M-norm: the set is Q diag(σ) Vᵀ plus
/// what was discarded; V is not kept.
struct Principal {
  petsc::Tall Q;          ///< M-orthonormal columns
  Eigen::VectorXd sigma;  ///< descending
  double discarded = 0;   ///< Σ of the squares of the σ that were dropped
};

/// Where the basis will be cut: after `size` directions, or (size 0) where σ falls below `tolerance` σ₁.
struct Cut {
  int size = 0;
  double tolerance = 1e-12;
};

/// The σ below which a direction cannot matter to the basis: a thousandth of the σ at the cut. It only grows while
/// blocks are added, since singular values do.
double negligible(const Principal& set, const Cut& cut);

/// What vectors that are never added may amount to, the root of the sum of their squares: half the tolerance in units
/// of σ₁, so that no σ moves by more [Weyl 1912]; for a cut by size, which knows no tolerance, what is negligible.
double dispensable(const Principal& set, const Cut& cut);

/// Adds the columns of `block` and drops what is negligible [Brand 2002]. *Collective*.
void add(Mat M, Principal& set, const petsc::ConstTallRef& block, const Cut& cut);

/// How many directions the cut keeps.
int kept(const Principal& set, const Cut& cut);

}  // namespace ritz::stages
