// A scene from its beginning to its end: time, or a load that grows.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ritz/base/error.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/energy_watch.hpp"

namespace ritz::world {

/// The floating point numbers that a run computes with.
enum class Precision : unsigned char { float64, float32 };

/// The cost of one step.
struct StepCost {
  double t = 0;        ///< time at the end of the step, s, or load fraction
  double seconds = 0;  ///< wall time, without recording the state
  int iterations = 0;  ///< Newton iterations
  int rejected = 0;    ///< attempts that did not converge, after which the step was halved
};

/// A state that a run reached, r numbers each.
struct Moment {
  double t = 0;                  ///< time, s, or load fraction
  Eigen::VectorXd z;             ///< √kg m
  Eigen::VectorXd velocity;      ///< z', √kg m/s; 0 in statics
  Eigen::VectorXd acceleration;  ///< z'', √kg m/s², in balance with z, z' and the load at t, whatever the integrator;
                                 ///< empty unless a probe of the body measures accelerations
};

/// Functions that a run calls: `cost` after each step, then `state` with the state that was reached, which is also
/// called once with the first state.
struct Observer {
  std::function<void(const Moment& now)> state;
  std::function<void(const StepCost& cost)> cost;
};

/// The reason why a run ended early.
enum class Cause : unsigned char {
  not_finite,     ///< a state is not finite, because the loads are too large
  not_converged,  ///< neither a step nor its halves converged
  free_body,      ///< statics of a body that nothing holds
  limit_point     ///< statics: the body snaps or buckles
};

/// The cause, where statics found no state of rest.
Cause cause_of(runtime::NoRest failure);

/// How and where a run ended early.
struct Failure {
  Cause cause = Cause::not_finite;
  std::int64_t step = 0;               ///< number of the step that failed, from 1
  double t = 0;                        ///< time at its end, s; of statics the load fraction that was reached
  double softest = 0;                  ///< at a limit point: the smallest eigenvalue of K̃, 1/s²
  double softest_at_rest = 0;          ///< the same at rest, 1/s²
  std::optional<Eigen::Index> pushed;  ///< statics of a free linear body: a rigid mode on which the load does work
};

/// A motion after some steps of its scene: all that the next step and the balance of energy depend on. A run that goes
/// on from it repeats one that did not stop, to the last bit.
struct Checkpoint {
  std::int64_t steps = 0;               ///< made since t = 0
  Eigen::MatrixXd history;              ///< as in runtime::State
  double last_dt = 0;                   ///< as in runtime::State, s
  std::optional<EnergyBalance> energy;  ///< only for nonlinear motions
  std::optional<EnergyGain> gain;
};

/// z and z', r numbers each, √kg m and √kg m/s.
struct GivenStart {
  Eigen::VectorXd z, velocity;
};

/// How a body starts: as the scene says; with the state of a motion file that the scene names; or where it stopped.
using Start = std::variant<std::monostate, GivenStart, Checkpoint>;

/// The estimated local errors of z (runtime::Outcome::error), √kg m. Of a vibration they are as much of velocity as of
/// displacement, of which the estimate sees the latter, 2/π of the whole on average: `sum` makes up for that. It bounds
/// the error of z as long as later steps do not enlarge the errors of earlier ones, as strongly nonlinear motions may.
struct StepErrors {
  double largest = 0;       ///< of one step
  double sum = 0;           ///< of all steps, times π/2
  double displacement = 0;  ///< the largest ‖z‖ that a step led to, by which they are to be measured
};

/// The outcome of a run, for one body.
struct RunResult {
  std::string_view integrator;                ///< its name; empty for statics
  std::int64_t steps = 0;                     ///< the number of steps of the run
  double seconds = 0;                         ///< wall time of stepping, without recording
  std::int64_t iterations = 0, rejected = 0;  ///< sums over all steps, as in StepCost
  std::optional<EnergyBalance> energy;        ///< only for nonlinear motions
  std::optional<StepErrors> errors;           ///< only of integrators that estimate them, for nonlinear motions
  std::optional<EnergyGain> gain;             ///< present if a nonlinear motion gained energy without work
  std::optional<BeyondTraining> beyond;       ///< present if a cubature was taken beyond its training
  std::optional<Checkpoint> last;             ///< where a motion ended
  std::optional<Failure> failure;             ///< present if the run ended early
};

/// Calls `work`. An InputError that it throws is thrown again with "body 'NAME': " before its message, or unchanged if
/// the name is empty.
template <class Work>
void naming(const std::string& body, Work work) try {
  work();
} catch (const InputError& error) {
  if (body.empty()) throw;
  throw InputError("body '" + body + "': " + error.what(), error.reason);
}

/// A body of a scene, by pointers that must be valid during the run.
struct Actor {
  const model::Body* body;
  const Observer* observer;
  Start start = {};  ///< of statics always the first alternative
};

/// Runs a scene: in time, from its start at t = 0, or from where all bodies stopped, to the end; or in statics, through
/// the load fractions 0, 1/steps, ... 1, between which the load is linear. `actors` has one entry for each of
/// scene.bodies, in the same order, or a single one if the scene names no bodies. All bodies make a step before any of
/// them makes the next, and the first failure ends the run. Bodies with the same model::Body share one equation.
/// Returns one result for each body. Throws InputError for loads, probes, steps or a start that a body does not admit,
/// and std::logic_error where the scene names a motion file and the actor has no start.
std::vector<RunResult> run(const scene::Scene& scene, std::span<const Actor> actors, Precision precision);

/// As above, for a scene that names no bodies.
RunResult run(const scene::Scene& scene, const model::Body& body, Precision precision, const Observer& observer);

}  // namespace ritz::world
