// Dynamics of the full model: implicit steps, each solved by Newton's method.
#pragma once
#include "ritz/stages/full_model.hpp"
#include "ritz/stages/full_statics.hpp"

namespace ritz::stages {

/// Integrators of M a + D v + f(u) = F(t), D = alpha M + beta K(0), over one step Δt from (u₀, v₀, a₀), d = u₁ − u₀:
///   avf: the mean of f along the straight step by Gauss quadrature, two points where f is cubic (exact), else four;
///   newmark: β = ¼, γ = ½;
///   implicit_euler: v₁ = d/Δt, a₁ = (v₁ − v₀)/Δt.
enum class FullIntegrator { avf, newmark, implicit_euler };

struct DynamicOptions {
  FullIntegrator integrator = FullIntegrator::avf;
  double alpha = 0;          ///< 1/s
  double beta = 0;           ///< s
  double dt = 0;             ///< step length, s
  double tolerance = 1e-10;  ///< ‖residual‖ over the sum of the norms of the forces when the step begins
};

/// Energies at the present time, J. W is the work of the loads, Q the energy that damping dissipated: E − E₀ = W − Q,
/// up to what the integrator and Newton's tolerance leave.
struct Energies {
  double kinetic = 0, elastic = 0;
  double work = 0;        ///< W = Σ d·(F₀ + F₁)/2
  double dissipated = 0;  ///< Q = Σ d·D d/Δt
  double start = 0;       ///< E₀

  double drift() const { return kinetic + elastic - start - work + dissipated; }
};

/// Everything that the next step depends on.
struct DynamicState {
  double t = 0;
  mesh::FreeRows u, v,
      a;  ///< m, m/s, m/s² over the free degrees of freedom; avf keeps the mean acceleration of its step
  Energies energies;
};

struct DynamicReport {
  std::int64_t newton_iterations = 0;
  std::int64_t factorizations = 0;  ///< of tangents, or set-ups of multigrid for one
  std::int64_t rejected = 0;        ///< steps that did not converge and were halved
  double gained = 0, lost = 0;      ///< the largest drift E − E₀ − W + Q above and below zero, J
};

/// *Collective*. Solves M a = F(t) − D v − f(u) for a, m/s².
algebra::Tall balanced_acceleration(const FullModel& model, const DynamicOptions& options, const DynamicState& state,
                                    const LoadAt& load);

/// *Collective*. Completes `state`, which is at rest at t = 0 or given: computes its energies and, for newmark, the
/// acceleration of balanced_acceleration.
DynamicState start_dynamics(FullModel& model, const DynamicOptions& options, DynamicState state, const LoadAt& load);

/// *Collective*. Makes `steps` steps of Δt, and calls `reached` after each with the report so far. A step that does not
/// converge is rejected and halved, never accepted. Throws a NumericalError that names its time and residual when
/// halving does not help.
DynamicReport full_dynamics(FullModel& model, const DynamicOptions& options, DynamicState state, std::int64_t steps,
                            const LoadAt& load,
                            const std::function<void(const DynamicState&, const DynamicReport&)>& reached);

}  // namespace ritz::stages
