// A scene from its beginning to its end: time, or a load that grows.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/base/error.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/energy_watch.hpp"

namespace ritz::world {

enum class Precision : unsigned char { twofold, single };

/// What one step took, without recording.
struct StepCost {
  double t = 0;  ///< s, or the load fraction
  double seconds = 0;
  int iterations = 0;  ///< Newton's
  int rejected = 0;    ///< attempts that did not converge and were halved
};

/// Is told of every state of a body, the first included, and of what each step took before its state comes.
struct Observer {
  std::function<void(double t, const Eigen::Ref<const Eigen::VectorXd>& z)> state;
  std::function<void(const StepCost& cost)> cost;
};

/// Why a run ended early.
enum class Cause : unsigned char {
  not_finite,     ///< a state is not finite: the loads are too large
  not_converged,  ///< neither a step nor its halves converge
  free_body,      ///< statics of a body that nothing holds
  limit_point     ///< statics: the body snaps or buckles
};

struct Failure {
  Cause cause = Cause::not_finite;
  std::int64_t step = 0;               ///< the one that failed, from 1
  double t = 0;                        ///< its end, s; of statics the load fraction that was reached
  double softest = 0;                  ///< at a limit point: the smallest eigenvalue of K̃, 1/s²
  double softest_at_rest = 0;          ///< the same at rest, 1/s²
  std::optional<Eigen::Index> pushed;  ///< of a free linear body: the rigid mode that the load pushes
};

struct RunResult {
  std::string_view integrator;  ///< its name; empty of statics
  std::int64_t steps = 0;
  double seconds = 0;  ///< of stepping alone
  std::int64_t iterations = 0, rejected = 0;
  std::optional<EnergyBalance> energy;  ///< of nonlinear motions
  std::optional<EnergyGain> gain;       ///< a warning, of nonlinear motions
  std::optional<Failure> failure;
};

/// Does `work`, and puts the name of the body that it is about in front of what an InputError of it says. Without a
/// name: as it is.
template <class Work>
void naming(const std::string& body, Work work) try {
  work();
} catch (const InputError& error) {
  if (body.empty()) throw;
  throw InputError("body '" + body + "': " + error.what(), error.reason);
}

/// A body of a scene: what it is made from, and who is told of it. Both must outlive the run.
struct Actor {
  const model::Body* body;
  const Observer* observer;
};

/// From rest at t = 0 to the scene's end, or through load fractions 0, 1/steps, ... 1, between which the load goes
/// straight. The actors stand in the order of scene.bodies; of a scene that names none there is one. All bodies make a
/// step before any makes the next, and the first failure ends the run. Bodies made from one model::Body share its
/// equation. Returns a result a body. Throws InputError for what the scene asks of a body that it cannot do.
std::vector<RunResult> run(const scene::Scene& scene, std::span<const Actor> actors, Precision precision);

/// The same for a scene of one body.
RunResult run(const scene::Scene& scene, const model::Body& body, Precision precision, const Observer& observer);

}  // namespace ritz::world
