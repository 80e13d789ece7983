// Time stepping, and the linearisation of a step: the derivative of the new state with respect to the old state and to
// the load.
#pragma once
#include <limits>
#include <optional>

#include "ritz/runtime/factors.hpp"
#include "ritz/runtime/integrator.hpp"
#include "ritz/runtime/model.hpp"

namespace ritz::runtime {

/// Everything that the next step depends on: a run that continues from a stored state repeats the original to the last
/// bit.
template <class Scalar>
struct State {
  Matrix<Scalar> history;  ///< r x history_size: z, z' (units of z per s), then the columns of the method's History
  Scalar last_dt = 0;      ///< length of the last step (of its last part, if it was halved), s; 0 before the first step
  std::optional<Frame<Scalar>> frame =
      {};  ///< of a carried body, whose history has 6 + r rows; z begins with six zeros

  auto z() const { return history.col(0); }
  auto velocity() const { return history.col(1); }
};

/// Where a body is.
template <class Scalar>
struct Configuration {
  VectorRef<Scalar> q;           ///< the coordinates; of a carried body the first six have no meaning of their own
  const Frame<Scalar>* carrier;  ///< the frame of a carried body; nullptr where there is none
};

/// A force that depends on the position of the body, such as a spring or a contact. Writes F(q), r, and ∂F/∂q, r x r,
/// to arrays that already have their sizes; s is the fraction of the step that has passed, 0 ... 1. For a carried body
/// F has 6 + r components: force (N) and torque (N m) about the origin, by the axes of the frame, then those of z. Its
/// derivative is then with respect to small motions of the frame by these axes, and to z.
template <class Scalar>
using PositionForce =
    std::function<void(const Configuration<Scalar>& at, Scalar s, Vector<Scalar>& force, Matrix<Scalar>& tangent)>;

/// The reduced load over a step: Uᵀf, linear in time from `begin` to `end`, r numbers each; and a force that depends on
/// the position, if any. For a carried body `begin` and `end` have 6 + r numbers by the axes of the frame and turn with
/// it; weight, whose direction is fixed, is a force of position.
template <class Scalar>
struct StepLoad {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
  const PositionForce<Scalar>* position = nullptr;
};

enum class Status : unsigned char {
  done,
  not_finite,    ///< a number was not finite; the state is as it was before the step
  not_converged  ///< neither the step nor its halves converged; the state is as it was before the step
};

/// What a step did, all of its parts together.
struct Outcome {
  Status status = Status::done;
  int iterations = 0;     ///< Newton iterations that computed a correction
  int evaluations = 0;    ///< of forces and tangents; the two points of a mean over the step (AVF) count as one
  int rejected = 0;       ///< attempts that failed and were halved
  double work = 0;        ///< of the loads, J: Σ δ·((f_n + f_{n+1})/2 + position force); NaN for steps from a table
  double dissipated = 0;  ///< by damping, J: Σ δ·D δ/Δt; NaN for steps from a table
  /// The internal energy where the step evaluated forces last, J; of a step in parts the largest. 0 for steps from a
  /// table.
  double elastic = 0;
  /// The estimated local error of z, √kg m: what the step adds to ‖z − exact z‖, of a carried body to that of its
  /// deformation; NaN where the method has no estimate, and for steps from a table.
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// When Newton's iteration ends: when the residual R satisfies ‖R‖ ≤ tolerance (‖inertia‖ + ‖f̃‖ + ‖loads and
/// history‖), or when δ changes by rounding errors alone. A correction that increases ‖R‖ is halved. Statics measure by
/// ‖load‖ instead.
template <class Scalar>
struct NewtonOptions {
  Scalar tolerance = sizeof(Scalar) == 8 ? Scalar(1e-10) : 50 * std::numeric_limits<Scalar>::epsilon();
  int iterations = 25;  ///< at most; then the attempt is rejected
  int halvings = 10;    ///< of a rejected step (statics: of the whole path), at most
};

/// The coefficients of a step of each oscillator, for one step length.
template <class Scalar>
struct OscillatorTables {
  double dt = 0;               ///< the step length, s
  Matrix<Scalar> step, start;  ///< r x history (history + 2): the entries of A (row by row), of b and of c
  Matrix<Scalar> next;         ///< work array, r x history
};

/// Work arrays of steps that solve an equation: by Newton's method, or once for explicit methods.
template <class Scalar>
struct NewtonRoom {
  Evaluation<Scalar> at_point;
  MeanEvaluation<Scalar> mean;
  InertiaAt<Scalar> inertia;
  Matrix<Scalar> jacobian;
  Factors<Scalar> factors;
  Vector<Scalar> target = {}, acceleration = {}, velocity = {}, delta = {}, point = {};
  Vector<Scalar> residual = {}, correction = {}, correction_taken = {}, begin = {}, end = {};
  Matrix<Scalar> next = {};
  State<Scalar> before;
  double highest_frequency = 0;  ///< of explicit methods: at rest, rad/s
  Scalar factored_dt = 0;        ///< of explicit methods: the step length for which M + drag D is factored, s
  // For a force that depends on the position; empty for loads that depend on time alone.
  Matrix<Scalar> position_tangent = {}, position_tangent_sum = {};
  Vector<Scalar> position_force = {}, position_point = {}, position_sum = {};
};

/// Whether the loads depend on time alone, or also on the position; in the second case oscillators, too, are stepped by
/// Newton's method.
enum class Loads : unsigned char { of_time, of_position };

/// The integrator, its options and its work arrays; every thread needs its own.
template <class Scalar>
struct Workspace {
  Integrator integrator;
  NewtonOptions<Scalar> options;
  Loads loads = Loads::of_time;
  std::variant<OscillatorTables<Scalar>, NewtonRoom<Scalar>> room;
};

/// Prepares steps of `dt` seconds, for oscillators from a table, for all other models by Newton's method. Throws
/// InputError when `dt` is not positive, when the integrator is not stable at this `dt`, or when it applies to
/// oscillators alone and the model or the loads are of another kind.
template <class Scalar>
Workspace<Scalar> make_workspace(const Model<Scalar>& model, const Integrator& integrator,
                                 std::type_identity_t<Scalar> dt, const NewtonOptions<Scalar>& options = {},
                                 Loads loads = Loads::of_time);

/// The acceleration a, r numbers, in balance with the given z and z' under the load `load`, r numbers each: the
/// solution of M a = load − D z' − f̃(z) − h. Overwrites `room`.
template <class Scalar>
Vector<Scalar> balanced_acceleration(const Model<Scalar>& model, VectorRef<Scalar> z, VectorRef<Scalar> velocity,
                                     VectorRef<Scalar> load, Evaluation<Scalar>& room);

/// The state with the given z and z' under the load `load`, r numbers each. Where the integrator needs the
/// acceleration, it is the balanced one. The frame of a carried body is at the origin; assign another one afterwards,
/// with a quaternion of unit length. `load` is by the axes of that frame.
template <class Scalar>
State<Scalar> make_state(const Model<Scalar>& model, const Integrator& integrator, VectorRef<Scalar> z,
                         VectorRef<Scalar> velocity, VectorRef<Scalar> load);

/// Makes one step of `dt` seconds with the integrator of the workspace. An attempt that does not converge or is not
/// finite is rejected, and its step is halved, as often as the options allow; if that is not enough the state is left
/// as it was. Does not allocate. Throws InputError when the integrator is not stable at this `dt`, and std::logic_error
/// for a position force in a workspace made for Loads::of_time.
template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace);

/// The energy ½ z'ᵀMz' + Ẽ(z), J. Overwrites `room`.
template <class Scalar>
Scalar energy(const Model<Scalar>& model, const State<Scalar>& state, Evaluation<Scalar>& room) {
  return energy<Scalar>(model, state.z(), state.velocity(), room);
}

/// With the h columns of the history one below the other in y, h r numbers,
///   dy_{n+1} = state dy_n + begin df_n + end df_{n+1}.
/// Of a carried body the first six of dy are small motions of the frame by its own axes (frame.hpp), before and after.
template <class Scalar>
struct StepDerivative {
  Matrix<Scalar> state;       ///< h r x h r
  Matrix<Scalar> begin, end;  ///< h r x r
};

/// Allocates the derivative for this model and integrator.
template <class Scalar>
StepDerivative<Scalar> make_step_derivative(const Model<Scalar>& model, const Integrator& integrator);

/// Makes a step as above and writes its derivative; for a step that was halved, by the chain rule over its parts. The
/// derivative is that of the exact solution of the step's equation, evaluated at the solution that was found. On
/// failure `derivative` is left as it was.
template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace, StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
