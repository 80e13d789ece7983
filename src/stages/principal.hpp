// The principal directions of a set of vectors that arrives in blocks.
#pragma once
#include "ritz/algebra/multivector.hpp"

namespace ritz::stages {

/// A truncated singular value decomposition, in the M-norm, of all vectors added so far: the set is Q diag(σ) Vᵀ plus
/// what was discarded. V is not kept.
struct Principal {
  algebra::Tall Q;        ///< M-orthonormal columns
  Eigen::VectorXd sigma;  ///< descending
  double discarded = 0;   ///< Σσ² over the σ that were dropped
};

/// Where the basis is cut: after `size` directions or, if size is 0, where σ falls below `tolerance` σ₁.
struct Cut {
  int size = 0;
  double tolerance = 1e-12;
};

/// The σ below which a direction does not matter to the basis: a thousandth of the σ at the cut. As blocks are added it
/// only grows, because singular values do.
double negligible(const Principal& set, const Cut& cut);

/// The size, as the root of the sum of squares, of the vectors that may be left out of the set altogether: half the
/// tolerance times σ₁, so that no σ changes by more [Weyl 1912]; for a cut by size, which has no tolerance, the value
/// of negligible().
double dispensable(const Principal& set, const Cut& cut);

/// *Collective*. Adds the columns of `block` and drops negligible directions [Brand 2002].
void add(const algebra::Matrix& M, Principal& set, const algebra::ConstTallRef& block, const Cut& cut);

/// The number of directions that the cut keeps.
int kept(const Principal& set, const Cut& cut);

}  // namespace ritz::stages
