// Equilibria of the full model under loads that grow in steps.
#pragma once
#include <functional>

#include "ritz/stages/full_model.hpp"

namespace ritz::stages {

/// *Collective*. The dead load at load fraction (or time) t, N over the free degrees of freedom.
using LoadAt = std::function<mesh::FreeRows(double t)>;

struct StaticOptions {
  int steps = 1;             ///< load fractions 1/steps, 2/steps, ... 1
  double tolerance = 1e-10;  ///< bound of ‖f(u) − F‖ / ‖F‖
};

struct StaticState {
  double fraction = 0;  ///< load fraction t
  mesh::FreeRows u;     ///< m
  double energy = 0;    ///< elastic energy, J
};

struct StaticReport {
  int newton_iterations = 0;
  int factorizations = 0;           ///< of tangents, or set-ups of multigrid for one
  int halvings = 0;                 ///< load increments that were halved
  std::int64_t inverted_cells = 0;  ///< at the end
};

/// *Collective*. Solves f(u) = F(t) from `start` to t = 1, and calls `reached` with the report so far after each step
/// beyond `start`. Newton's method takes full steps. An increment is halved if it does not converge, if (with the
/// direct solver) it ends where the tangent has negative eigenvalues, or if it inverts more cells at once. Throws a
/// NumericalError that names the load fraction reached when halving no longer helps: it speaks of "a limit point of the
/// load or a bifurcation", beyond which dead loads find no stable equilibrium, only if the tangent loses its
/// definiteness within about twice the increment that failed. Throws InputError when the supports leave rigid motions
/// free.
StaticReport full_statics(FullModel& model, const StaticOptions& options, StaticState start, const LoadAt& load,
                          const std::function<void(const StaticState&, const StaticReport&)>& reached);

}  // namespace ritz::stages
