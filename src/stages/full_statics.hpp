// Equilibria of the full model under loads that grow step by step.
#pragma once
#include <functional>

#include "ritz/stages/full_model.hpp"

namespace ritz::stages {

/// The dead load at load fraction (or time) t, N over the free degrees of freedom. *Collective*.
using LoadAt = std::function<mesh::FreeRows(double t)>;

struct StaticOptions {
  int steps = 1;             ///< load fractions 1/steps, 2/steps, ... 1
  double tolerance = 1e-10;  ///< ‖f(u) − F‖ / ‖F‖
};

struct StaticState {
  double fraction = 0;
  mesh::FreeRows u;  ///< m
  double energy = 0;
};

struct StaticReport {
  int newton_iterations = 0;
  int factorizations = 0;           ///< of tangents, or set-ups of multigrid for one
  int halvings = 0;                 ///< load increments that had to be cut in two
  std::int64_t inverted_cells = 0;  ///< at the end
};

/// f(u) = F(t) from `start` on to t = 1; `reached` is called after each of the steps that lie beyond it, with the
/// report so far. Newton takes full steps; an increment that does not converge, or with the direct solver lands where
/// the tangent has negative eigenvalues, is halved; so is one that turns more cells inside out, until they do so
/// without a jump. Throws NumericalError that names the load fraction reached, where halving no longer helps: "a limit
/// point of the load or a bifurcation", past which dead loads find no stable equilibrium, only where the tangent loses
/// its definiteness within about twice the increment that failed; else that nothing was found. Throws InputError when
/// the supports leave the body rigid motions. *Collective*.
StaticReport full_statics(FullModel& model, const StaticOptions& options, StaticState start, const LoadAt& load,
                          const std::function<void(const StaticState&, const StaticReport&)>& reached);

}  // namespace ritz::stages
