// The nonlinear reduced model at rest under a load that grows.
#pragma once
#include "ritz/runtime/factors.hpp"
#include "ritz/runtime/nonlinear.hpp"
#include "ritz/runtime/nonlinear_step.hpp"

namespace ritz::runtime {

/// A load that goes straight from one value to another, and the load fractions that messages call the two.
template <class Scalar>
struct LoadPath {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
  double from = 0;
  double to = 1;
};

/// Room for statics; one a thread.
template <class Scalar>
struct StaticWorkspace {
  NewtonOptions<Scalar> options;
  Evaluation<Scalar> at;
  Factors<Scalar> factors;
  Vector<Scalar> trial, load, residual;
};

/// Throws InputError when K̃(0) is singular: the body is free, and a load would set it moving.
template <class Scalar>
StaticWorkspace<Scalar> make_static_workspace(const NonlinearModel<Scalar>& model,
                                              const NewtonOptions<Scalar>& options = {.halvings = 16});

/// Follows f̃(z) = load from z, at rest under path.begin, to the rest under path.end, by Newton's method; an increment
/// that does not converge to a stable state (K̃ positive definite) is halved. Throws NumericalError, naming the load
/// fraction reached, where halving no longer helps: "a limit point" only where K̃ ceases to be positive definite within
/// about twice the increment that failed. Then z is the last state that was found.
template <class Scalar>
NonlinearOutcome solve_static(const NonlinearModel<Scalar>& model, const LoadPath<Scalar>& path, Vector<Scalar>& z,
                              StaticWorkspace<Scalar>& workspace);

}  // namespace ritz::runtime
