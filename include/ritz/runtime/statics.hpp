// Static equilibrium of a model under a load that grows.
#pragma once
#include <optional>

#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// A load that changes linearly from `begin` to `end`; r numbers each.
template <class Scalar>
struct LoadPath {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
};

/// Options, work arrays and what is known of K̃(0); every thread needs its own. Linear models use none of it.
template <class Scalar>
struct StaticWorkspace {
  NewtonOptions<Scalar> options;
  double softest_at_rest = 0;  ///< the smallest eigenvalue of K̃(0), 1/s²
  bool held = false;  ///< whether that exceeds 1e-10 of the largest diagonal entry of K̃(0); else the body is free
  Evaluation<Scalar> at = {};
  Factors<Scalar> factors = {};
  Vector<Scalar> trial, load, residual;
};

/// Allocates the work arrays and computes the smallest eigenvalue of K̃(0).
template <class Scalar>
StaticWorkspace<Scalar> make_static_workspace(const Model<Scalar>& model,
                                              const NewtonOptions<Scalar>& options = {.halvings = 16});

/// Why no equilibrium was found.
enum class NoRest : unsigned char {
  free_body,      ///< the supports leave rigid motions free; for a linear model, the load pushes one
  limit_point,    ///< K̃ loses positive definiteness within about twice the increment that failed
  not_converged,  ///< Newton's method does not converge, even with halved increments
  not_finite      ///< the load is not finite
};

struct StaticOutcome {
  std::optional<NoRest> failure;  ///< none: z is the equilibrium under path.end
  double reached = 1;             ///< the fraction of the path at which z is in equilibrium, 0 ... 1
  int iterations = 0;             ///< Newton iterations of all increments together
  int evaluations = 0;            ///< of the internal force and its tangent
  int rejected = 0;               ///< increments that were halved, as they did not converge to a stable state
  double softest = 0;             ///< at a limit point: the smallest eigenvalue of K̃ at the last state found, 1/s²
  Eigen::Index pushed = 0;        ///< for a free linear model: the rigid mode that the load acts on
};

/// Solves f̃(z) = load along the path, from z, the equilibrium under path.begin, to the equilibrium under path.end.
/// A linear model is solved directly: z_i = f_i / λ_i. A rigid mode (λ_i = 0) gets z_i = 0, and it is an error
/// (free_body) if its |f_i| exceeds 1e-8 of the largest.
/// A nonlinear model is solved by Newton's method, until ‖f̃ − load‖ ≤ tolerance ‖load‖. An increment that does not
/// converge to a stable state (K̃ positive definite), or that passes an unstable one, is halved. A model that is not
/// held (see StaticWorkspace) fails at once as a free_body. On failure z is the last state found.
template <class Scalar>
StaticOutcome solve_static(const Model<Scalar>& model, const LoadPath<Scalar>& path, Vector<Scalar>& z,
                           StaticWorkspace<Scalar>& workspace);

}  // namespace ritz::runtime
