// Stepping a model through time.
#pragma once
#include <limits>
#include <optional>

#include "ritz/runtime/factors.hpp"
#include "ritz/runtime/integrator.hpp"
#include "ritz/runtime/model.hpp"

namespace ritz::runtime {

/// Everything the next step depends on: store it and go on later, to the last bit.
template <class Scalar>
struct State {
  Matrix<Scalar> history;  ///< r x history_size: columns z, z' (units of z per s), then the integrator's own
  Scalar last_dt = 0;      ///< length of the last step (or of its last part), s; 0 at the start
  std::optional<Frame<Scalar>> frame = {};  ///< of a body that one carries; then the first six of z are 0

  auto z() const { return history.col(0); }
  auto velocity() const { return history.col(1); }
};

/// Where a body is.
template <class Scalar>
struct Configuration {
  VectorRef<Scalar> q;           ///< coordinates; of a carried body the first six mean nothing
  const Frame<Scalar>* carrier;  ///< the frame; nullptr where none carries the body
};

/// A force that depends on where the body is: a spring, a contact. Writes F(q), r, and ∂F/∂q, r x r, into arrays that
/// have their sizes; s is how much of the step has passed, 0 ... 1. Of a carried body F acts on the velocity ν of
/// frame.hpp (force and torque by the frame's axes, N and N m, then r numbers), and its derivative is by small motions
/// of the frame by these axes, and by z.
template <class Scalar>
using PositionForce =
    std::function<void(const Configuration<Scalar>& at, Scalar s, Vector<Scalar>& force, Matrix<Scalar>& tangent)>;

/// The reduced force over a step: Uᵀf, linear between its ends, each of r numbers; and what depends on the position.
template <class Scalar>
struct StepLoad {
  VectorRef<Scalar> begin;
  VectorRef<Scalar> end;
  const PositionForce<Scalar>* position = nullptr;
};

enum class Status : unsigned char {
  done,
  not_finite,    ///< the step was rejected, the state is as before
  not_converged  ///< the same: neither the step nor its halves converged
};

struct Outcome {
  Status status = Status::done;
  int iterations = 0;     ///< Newton iterations that solved for a correction, all parts of the step together
  int evaluations = 0;    ///< of forces and tangents; along a step (AVF) two points count as one
  int rejected = 0;       ///< attempts that did not converge, and were halved
  double work = 0;        ///< of the load, J: Σ δ·(f_n + f_{n+1})/2 over the parts; NaN of steps from a table
  double dissipated = 0;  ///< by damping, J: Σ δ·D δ/Δt over the parts; NaN of steps from a table
};

/// When Newton's iteration ends: ‖R‖ ≤ tolerance (‖inertia‖ + ‖force‖ + ‖the rest‖), or δ changes by rounding alone. A
/// correction that enlarges ‖R‖ is halved.
template <class Scalar>
struct NewtonOptions {
  Scalar tolerance = sizeof(Scalar) == 8 ? Scalar(1e-10) : 50 * std::numeric_limits<Scalar>::epsilon();
  int iterations = 25;  ///< at most; then the step is rejected
  int halvings = 10;    ///< of a rejected step, at most
};

/// The steps of oscillators, tabulated for one length of step.
template <class Scalar>
struct OscillatorTables {
  double dt = 0;
  Matrix<Scalar> step, start;  ///< r x history (history + 2): columns A (row by row), then b, then c
  Matrix<Scalar> next;         ///< r x history
};

/// Room for steps whose equation is solved: by Newton's method, or of explicit methods once.
template <class Scalar>
struct NewtonRoom {
  Evaluation<Scalar> at_point;
  MeanEvaluation<Scalar> mean;
  InertiaAt<Scalar> inertia;
  Matrix<Scalar> jacobian;
  Factors<Scalar> factors;
  Vector<Scalar> target = {}, acceleration = {}, velocity = {}, delta = {}, point = {};
  Vector<Scalar> residual = {}, correction = {}, correction_taken = {}, begin = {}, end = {};
  State<Scalar> before;
  double highest_frequency = 0;  ///< rad/s at rest, of explicit methods
  Scalar factored_dt = 0;        ///< s, whose M + drag D an explicit method has factored
  // Of a force that depends on the position; empty for loads of time.
  Matrix<Scalar> position_tangent = {}, position_tangent_sum = {};
  Vector<Scalar> position_force = {}, position_point = {}, position_sum = {};
};

/// Whether loads have a part that depends on the position: then oscillators, too, are stepped by Newton's method.
enum class Loads : unsigned char { of_time, of_position };

/// Room for a step; one a thread.
template <class Scalar>
struct Workspace {
  Integrator integrator;
  NewtonOptions<Scalar> options;
  Loads loads = Loads::of_time;
  std::variant<OscillatorTables<Scalar>, NewtonRoom<Scalar>> room;
};

/// Oscillators take steps from a table, all others by Newton's method. Throws InputError when `dt` is not positive, or
/// where the integrator cannot take it or not such a model.
template <class Scalar>
Workspace<Scalar> make_workspace(const Model<Scalar>& model, const Integrator& integrator,
                                 std::type_identity_t<Scalar> dt, const NewtonOptions<Scalar>& options = {},
                                 Loads loads = Loads::of_time);

/// The state with given z and z' under the force `load`; its acceleration solves M a = load − D z' − f̃(z) − h. The
/// frame of a carried body is at the origin; put it elsewhere afterwards.
template <class Scalar>
State<Scalar> make_state(const Model<Scalar>& model, const Integrator& integrator, VectorRef<Scalar> z,
                         VectorRef<Scalar> velocity, VectorRef<Scalar> load);

/// One step of `dt` seconds with the workspace's integrator. An attempt that does not converge or is not finite is
/// rejected and halved, as often as the options allow; when that is not enough the state is left as it was. Does not
/// allocate. Throws InputError where the integrator cannot take `dt`, and std::logic_error for a force of position in a
/// workspace that was made for loads of time.
template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace);

/// ½ z'ᵀMz' + Ẽ(z), J.
template <class Scalar>
Scalar energy(const Model<Scalar>& model, const State<Scalar>& state, Evaluation<Scalar>& room) {
  return energy<Scalar>(model, state.z(), state.velocity(), room);
}

}  // namespace ritz::runtime
