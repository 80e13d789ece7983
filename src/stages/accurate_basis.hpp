// Finds the smallest basis that is accurate enough on a static load path.
#pragma once
#include "ritz/stages/basis.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

namespace ritz::stages {

/// Equilibria of the full model under growing loads. One column for each load level, ascending; rows of free degrees of
/// freedom.
struct StaticPath {
  mesh::FreeRows loads;  ///< F, N
  mesh::FreeRows truth;  ///< u of the full model with f(u) = F, m; no column is zero
};

/// The size of a basis, and its error on a path: the largest ‖u − Uz‖_M / ‖u‖_M over the load levels, where z is the
/// equilibrium of the reduced model under UᵀF; infinite if it has none.
struct SizedError {
  int modes = 0;    ///< K', the number of modes and of modes with derivatives
  int columns = 0;  ///< r
  double error = 0;
};

struct AccurateBasis {
  BasisResult basis;
  SizedError chosen;
};

/// *Collective*. Tries the bases of Eq. 18 made from the first K' = 1, 2, ... flexible modes and all their derivatives,
/// and takes the one with the fewest columns r whose error is at most `target`. The search ends when three further
/// values of K' have not made r smaller. Reduced equilibria are computed with the polynomial; one polynomial for each
/// K' serves all r, because the principal directions of a smaller basis are the first ones of a larger.
///
/// Throws a NumericalError that names the best basis found, when no basis of the given modes is accurate enough.
AccurateBasis accurate_basis(const Problem& problem, const PolynomialLaws& laws, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress);

}  // namespace ritz::stages
