// A model at rest under a load that grows.
#pragma once
#include <optional>

#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// A load that goes straight from one value to another; each of r numbers.
template <class Scalar>
struct LoadPath {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
};

/// Room for statics; one a thread.
template <class Scalar>
struct StaticWorkspace {
  NewtonOptions<Scalar> options;
  double softest_at_rest = 0;  ///< smallest eigenvalue of K̃(0), 1/s²
  bool held = false;           ///< whether that is above 1e-10 of K̃(0)'s largest entry; else the body is free
  Evaluation<Scalar> at = {};
  Factors<Scalar> factors = {};
  Vector<Scalar> trial, load, residual;
};

template <class Scalar>
StaticWorkspace<Scalar> make_static_workspace(const Model<Scalar>& model,
                                              const NewtonOptions<Scalar>& options = {.halvings = 16});

/// Why no state of rest was found.
enum class NoRest : unsigned char {
  free_body,      ///< nothing holds the body against a rigid motion, and the load sets it moving
  limit_point,    ///< K̃ ceases to be positive definite within about twice the increment that failed
  not_converged,  ///< Newton's method does not converge, and halving the increments does not help
  not_finite      ///< the load is not finite
};

struct StaticOutcome {
  std::optional<NoRest> failure;  ///< nothing: z is at rest under path.end
  double reached = 1;             ///< how much of the path was gone, 0 ... 1
  int iterations = 0;             ///< Newton iterations, of all increments together
  int evaluations = 0;            ///< of forces and tangents
  int rejected = 0;               ///< increments that were halved
  double softest = 0;             ///< at a limit point: the smallest eigenvalue of K̃ where the path ended, 1/s²
  Eigen::Index pushed = 0;        ///< of a free linear model: the rigid mode that the load pushes
};

/// Follows f̃(z) = load from z, at rest under path.begin, to the rest under path.end. A linear model is solved at once,
/// z_i = f_i / λ_i; a rigid mode (λ = 0) stays 0, and the load may push one by 1e-8 of the largest |f_i|. Others by
/// Newton's method, where an increment that does not converge to a stable state (K̃ positive definite) is halved. Where
/// that fails, z is the last state that was found.
template <class Scalar>
StaticOutcome solve_static(const Model<Scalar>& model, const LoadPath<Scalar>& path, Vector<Scalar>& z,
                           StaticWorkspace<Scalar>& workspace);

}  // namespace ritz::runtime
