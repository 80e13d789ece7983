// Finds the smallest basis that is accurate enough on a static load path.
#pragma once
#include <functional>

#include "ritz/runtime/model.hpp"
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
  int columns = 0;  ///< r, those of the static path's Taylor series included
  double error = 0;
};

struct AccurateBasis {
  BasisResult basis;
  SizedError chosen;
};

/// *Collective*. Every basis tried begins with the first two terms of the path's Taylor series in the load, w and Φ_ww
/// with K w = F and K Φ_ww = −(H:w) w, where F is the last load: with them u is right to the order ‖F‖². Then follow
/// the bases of Eq. 18 made from the first K' = 0, 1, 2, ... flexible modes and all their derivatives. The one with the
/// fewest columns r whose error is at most `target` is taken. The search ends when three further values of K' have not
/// made r smaller, or none can. Reduced equilibria are computed with the polynomial; one polynomial for each K' serves
/// all r, because the columns of a smaller basis span the same as the first ones of a larger.
///
/// Throws a NumericalError that names the best basis found, when no basis of the given modes is accurate enough.
AccurateBasis accurate_basis(const Problem& problem, const PolynomialLaws& laws, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress);

/// Makes the reduced model of a basis, of any law. *Collective*.
using ReducedModel = std::function<runtime::Model<double>(const BasisResult& basis)>;

/// *Collective*. The same where reduced models take long to make, as those of cubature do: of the bases above that K'
/// is taken with which the fewest columns can represent the path to half of the target, and r grows from there, by a
/// fifth at a time, until the equilibria of `reduced` are accurate enough.
AccurateBasis accurate_basis(const Problem& problem, const ReducedModel& reduced, const ModesResult& modes,
                             const StaticPath& path, double target, const ModesProgress& progress);

}  // namespace ritz::stages
