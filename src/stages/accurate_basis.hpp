// The smallest basis that is accurate enough on a static load path.
#pragma once
#include "ritz/stages/basis.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

namespace ritz::stages {

/// Equilibria of the full model under growing loads. Columns are load levels, ascending; rows free degrees of freedom.
struct StaticPath {
  mesh::FreeRows loads;  ///< F, N
  mesh::FreeRows truth;  ///< u with f(u) = F, m; no column is zero
};

/// A basis by its size, and its error on a path: the largest ‖u − Uz‖_M / ‖u‖_M of a level, z the reduced model's own
/// equilibrium under UᵀF; infinite where it finds none.
struct SizedError {
  int modes = 0;    ///< K', of modes and of derivatives
  int columns = 0;  ///< r
  double error = 0;
};

struct AccurateBasis {
  BasisResult basis;
  SizedError chosen;
};

/// Eq. 18's bases of the first K' = 1, 2, ... flexible modes and all their derivatives, of which the one of fewest
/// columns r with an error of at most `target` is taken; the search ends where three more values of K' have not made r
/// smaller. Reduced equilibria are those of the polynomial, of which one a K' serves all r: the principal directions of
/// a smaller basis are the first ones of a larger.
///
/// Throws NumericalError, naming the best that was found, when no basis of the modes given is accurate enough.
/// *Collective*.
AccurateBasis accurate_basis(const Problem& problem, const PolynomialLaws& laws, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress);

}  // namespace ritz::stages
