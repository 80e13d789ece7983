// Stepping a nonlinear model through time.
#pragma once
#include <limits>

#include "ritz/runtime/factors.hpp"
#include "ritz/runtime/method.hpp"
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// When Newton's iteration ends: ‖R‖ ≤ tolerance (‖inertia δ‖ + ‖share F‖ + ‖target‖), or δ changes by rounding alone.
/// A correction that enlarges ‖R‖ is halved.
template <class Scalar>
struct NewtonOptions {
  Scalar tolerance = sizeof(Scalar) == 8 ? Scalar(1e-10) : 50 * std::numeric_limits<Scalar>::epsilon();
  int iterations = 25;  ///< at most; then the step is rejected
  int halvings = 10;    ///< of a rejected step, at most
};

/// Room for a step; one a thread.
template <class Scalar>
struct NonlinearWorkspace {
  Method<Scalar> method;
  NewtonOptions<Scalar> options;
  Evaluation<Scalar> at_point;
  MeanEvaluation<Scalar> mean;
  StepEquation<Scalar> equation;
  Matrix<Scalar> jacobian;
  Factors<Scalar> factors;
  Vector<Scalar> delta, point, residual, correction, begin, end;
  Vector<Scalar> from;  ///< z where the part of the step begins
  NonlinearState<Scalar> before;
  Scalar stable_dt = std::numeric_limits<Scalar>::infinity();  ///< s, of an explicit method at rest
  Scalar factored_dt = 0;                                      ///< s, whose I + Δt D/2 an explicit method has factored
};

/// Throws InputError when `dt` is not positive, or where the method cannot take it.
template <class Scalar>
NonlinearWorkspace<Scalar> make_workspace(const NonlinearModel<Scalar>& model, const Method<Scalar>& method, Scalar dt,
                                          const NewtonOptions<Scalar>& options = {});

struct NonlinearOutcome {
  Status status = Status::done;
  int iterations = 0;     ///< Newton iterations that solved for a correction, all parts of the step together
  int evaluations = 0;    ///< of forces and tangents; along a step (AVF) two points count as one
  int rejected = 0;       ///< attempts that did not converge, and were halved
  double work = 0;        ///< of the load, J: Σ δ·(f_n + f_{n+1})/2 over the parts of the step
  double dissipated = 0;  ///< by damping, J: Σ δ·D δ/Δt over the parts of the step
};

/// One step of `dt` seconds. An attempt that does not converge or is not finite is rejected and halved, as often as the
/// options allow; when that is not enough the state is left as it was. Does not allocate. Throws InputError where an
/// explicit method cannot take `dt`.
template <class Scalar>
NonlinearOutcome step(const NonlinearModel<Scalar>& model, NonlinearState<Scalar>& state,
                      const NonlinearLoad<Scalar>& load, Scalar dt, NonlinearWorkspace<Scalar>& workspace);

/// The Jacobian of R at δ in the workspace: inertia I + drag D + share F'(δ), r x r. `equation` is that of the step.
template <class Scalar>
void linearise(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state, const Vector<Scalar>& delta,
               NonlinearWorkspace<Scalar>& workspace);

}  // namespace ritz::runtime
