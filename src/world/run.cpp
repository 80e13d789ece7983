#include "ritz/world/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "ritz/world/loads.hpp"

namespace ritz::world {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Whether the energy is looked at after step n, which costs an evaluation: about `looks` times while n doubles. A rule
/// of n alone, so that a motion which goes on is looked at as if it had not stopped.
bool is_due(std::int64_t n) {
  constexpr std::int64_t looks = 64;
  std::int64_t every = 1;
  while (every * looks * 2 <= n) every *= 2;
  return n % every == 0;
}

void add(const StepCost& cost, const Observer& observer, RunResult& result) {
  result.seconds += cost.seconds;
  result.iterations += cost.iterations;
  result.rejected += cost.rejected;
  observer.cost(cost);
}

template <class Scalar>
void add(const runtime::Outcome& outcome, const runtime::State<Scalar>& state, RunResult& result) {
  if (std::isnan(outcome.error)) return;
  auto& errors = result.errors ? *result.errors : result.errors.emplace();
  errors.largest = std::max(errors.largest, outcome.error);
  errors.sum += M_PI / 2 * outcome.error;
  errors.displacement = std::max(errors.displacement, static_cast<double>(state.z().norm()));
}

/// `elastic`: the internal energy at t, J.
void compare_with_training(const std::optional<model::Cubature>& cubature, double t, double elastic,
                           RunResult& result) {
  if (!cubature || !(elastic > cubature->largest_energy)) return;
  if (!result.beyond) result.beyond = BeyondTraining{.since = t};
  result.beyond->largest = std::max(result.beyond->largest, elastic / cubature->largest_energy);
}

/// Looks at the energy of a nonlinear motion, now and then.
template <class Scalar>
class Watch {
 public:
  /// `from`: where the motion stopped, if it goes on.
  Watch(const Instance<Scalar>& instance, const Checkpoint* from)
      : instance_(instance), room_(runtime::make_evaluation(instance.model->force)), watch_(energy()) {
    if (from && from->energy) watch_ = EnergyWatch(*from->energy, from->gain);
  }

  void after(std::int64_t n, double t, const runtime::Outcome& outcome) {
    watch_.add(outcome.work, outcome.dissipated);
    if (is_due(n)) watch_.look(t, energy());
  }
  /// The end is looked at too, which whoever goes on from there must not know of.
  void report(double t, RunResult& result) {
    if (result.last) {
      result.last->energy = watch_.balance();
      result.last->gain = watch_.gain();
    }
    auto whole = watch_;
    whole.look(t, energy());
    result.energy = whole.balance();
    result.gain = whole.gain();
  }

 private:
  double energy() { return static_cast<double>(runtime::energy(*instance_.model, instance_.state, room_)); }

  const Instance<Scalar>& instance_;
  runtime::Evaluation<Scalar> room_;
  EnergyWatch watch_;
};

/// z, in equilibrium under the load.
template <class Scalar>
runtime::Vector<Scalar> rest_under(const runtime::Model<Scalar>& model, const runtime::Vector<Scalar>& load) {
  runtime::Vector<Scalar> z = runtime::Vector<Scalar>::Zero(model.size());
  const runtime::Vector<Scalar> none = z;
  auto workspace = runtime::make_static_workspace<Scalar>(model);
  const auto outcome = runtime::solve_static<Scalar>(model, {none, load}, z, workspace);
  if (!outcome.failure) return z;
  const std::string none_there = "there is no static state to start from: ";
  switch (*outcome.failure) {
    case runtime::NoRest::free_body:
      throw InputError(none_there + "the body is free, and nothing holds it against the load at t = 0");
    case runtime::NoRest::limit_point:
      throw NumericalError(none_there + "the body snaps or buckles before it bears the load at t = 0");
    case runtime::NoRest::not_converged:
      throw NumericalError(none_there + "Newton's method does not converge under the load at t = 0");
    case runtime::NoRest::not_finite: throw NumericalError(none_there + "the load at t = 0 is not finite");
  }
  throw std::logic_error("a failure without a cause");
}

/// r numbers of the scene, or zeros.
Eigen::VectorXd coordinates(const std::vector<double>& given, const std::string& what, Eigen::Index r) {
  if (given.empty()) return Eigen::VectorXd::Zero(r);
  if (std::ssize(given) != r)
    throw InputError("the motion would start with " + std::to_string(given.size()) + " numbers of " + what +
                     ", and the model has " + std::to_string(r) + " reduced coordinates");
  return Eigen::Map<const Eigen::VectorXd>(given.data(), r);
}

/// z and z' at t = 0, under the load `load`.
template <class Scalar>
GivenStart start_of(const scene::Scene& scene, const Start& start, const runtime::Model<Scalar>& model,
                    const runtime::Vector<Scalar>& load) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.size());
  if (const auto* given = std::get_if<GivenStart>(&start)) {
    if (given->z.size() != rest.size() || given->velocity.size() != rest.size())
      throw InputError("the state to start from has " + std::to_string(given->z.size()) +
                       " coordinates, and the model " + std::to_string(rest.size()));
    return *given;
  }
  if (!scene.initial) return {rest, rest};
  if (std::holds_alternative<scene::StaticStart>(*scene.initial))
    return {rest_under<Scalar>(model, load).template cast<double>(), rest};
  if (const auto* given = std::get_if<scene::CoordinateStart>(&*scene.initial))
    return {coordinates(given->z, "z", rest.size()), coordinates(given->velocity, "its velocity", rest.size())};
  throw std::logic_error("whoever runs a scene that names a motion file reads it");
}

/// Puts an instance where it stopped.
template <class Scalar>
void go_on(const Checkpoint& from, Instance<Scalar>& instance) {
  auto& history = instance.state.history;
  if (from.history.rows() != history.rows() || from.history.cols() != history.cols())
    throw InputError("the state to go on from is not one of this model and this integrator");
  history = from.history.template cast<Scalar>();
  instance.state.last_dt = static_cast<Scalar>(from.last_dt);
}

template <class Scalar>
using Shared = std::shared_ptr<const runtime::Model<Scalar>>;

/// A body on its way through time.
template <class Scalar>
class Moving {
 public:
  Moving(const scene::Scene& scene, Shared<Scalar> model, const Actor& actor)
      : scene_(scene),
        time_(std::get<scene::Time>(scene.analysis)),
        observer_(*actor.observer),
        cubature_(actor.body->cubature),
        load_(reduce_loads(scene, *actor.body)),
        force_(model->size()),
        end_(model->size()) {
    const auto* from = std::get_if<Checkpoint>(&actor.start);
    done_ = from ? from->steps : 0;
    load_.evaluate(scene_, time(), force_);
    end_ = force_.cast<Scalar>();
    const auto integrator = choose(time_.integrator, *model);
    const auto start = from ? GivenStart{Eigen::VectorXd::Zero(model->size()), Eigen::VectorXd::Zero(model->size())}
                            : start_of<Scalar>(scene_, actor.start, *model, end_);
    instance_ = make_instance<Scalar>(model, integrator, Scalar(time_.step), start.z.template cast<Scalar>().eval(),
                                      start.velocity.template cast<Scalar>().eval(), end_);
    if (from) go_on(*from, instance_);
    refuse_undefined_start();
    result_.integrator = integrator.name;
    result_.steps = scene::step_count(time_) - done_;
    if (!runtime::is_oscillators(*model)) watch_.emplace(instance_, from);
    if (scene::any_measures(scene_.probes, scene::Quantity::acceleration))
      room_.emplace(runtime::make_evaluation(model->force));
    tell();
  }
  Moving(const Moving&) = delete;  // the watch looks at the instance
  Moving& operator=(const Moving&) = delete;

  /// Whether it got there.
  bool step(std::int64_t n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) * time_.step;
    load_.evaluate(scene_, t, force_);
    end_ = force_.cast<Scalar>();
    const auto outcome = world::step<Scalar>(instance_, end_);
    add({t, seconds_since(started), outcome.iterations, outcome.rejected}, observer_, result_);
    if (outcome.status != runtime::Status::done) {
      const bool finite = outcome.status == runtime::Status::not_converged;
      result_.failure = {.cause = finite ? Cause::not_converged : Cause::not_finite, .step = n, .t = t, .pushed = {}};
      return false;
    }
    done_ = n;
    if (watch_) watch_->after(n, t, outcome);
    compare_with_training(cubature_, t, outcome.elastic, result_);
    add(outcome, instance_.state, result_);
    tell();
    return true;
  }

  RunResult result() {
    auto result = result_;
    if (!result.failure)
      result.last = {.steps = done_,
                     .history = instance_.state.history.template cast<double>(),
                     .last_dt = static_cast<double>(instance_.state.last_dt),
                     .energy = {},
                     .gain = {}};
    if (watch_) watch_->report(time(), result);
    return result;
  }

 private:
  double time() const { return static_cast<double>(done_) * time_.step; }

  void refuse_undefined_start() const {
    auto room = runtime::make_evaluation(instance_.model->force);
    if (!runtime::admits<Scalar>(instance_.model->force, instance_.state.z(), room))
      throw InputError(
          "the motion would start where a material's law is not defined, with a cell turned inside out: start with a "
          "smaller deformation");
  }

  void tell() {
    const auto& state = instance_.state;
    now_.t = time();
    now_.z = state.z().template cast<double>();
    now_.velocity = state.velocity().template cast<double>();
    if (room_)
      now_.acceleration =
          runtime::balanced_acceleration<Scalar>(*instance_.model, state.z(), state.velocity(), instance_.load, *room_)
              .template cast<double>();
    observer_.state(now_);
  }

  const scene::Scene scene_;
  const scene::Time time_;
  const Observer& observer_;
  const std::optional<model::Cubature>& cubature_;
  ReducedLoad load_;
  Eigen::VectorXd force_;
  runtime::Vector<Scalar> end_;
  Instance<Scalar> instance_;
  std::optional<Watch<Scalar>> watch_;
  std::optional<runtime::Evaluation<Scalar>> room_;  ///< where accelerations are measured
  std::int64_t done_ = 0;                            ///< steps since t = 0
  Moment now_;
  RunResult result_;
};

/// A body whose load grows.
template <class Scalar>
class Loading {
 public:
  Loading(const scene::Scene& scene, Shared<Scalar> model, const Actor& actor)
      : scene_(scene),
        model_(std::move(model)),
        observer_(*actor.observer),
        cubature_(actor.body->cubature),
        load_(reduce_loads(scene, *actor.body)),
        workspace_(runtime::make_static_workspace<Scalar>(*model_)),
        force_(model_->size()),
        z_(runtime::Vector<Scalar>::Zero(model_->size())),
        begin_(z_),
        end_(z_) {
    result_.steps = std::get<scene::Static>(scene.analysis).steps;
  }

  bool step(std::int64_t n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) / static_cast<double>(result_.steps);
    load_.evaluate(scene_, t, force_);
    end_ = force_.cast<Scalar>();
    const auto outcome = runtime::solve_static<Scalar>(*model_, {begin_, end_}, z_, workspace_);
    const StepCost cost{t, seconds_since(started), outcome.iterations, outcome.rejected};
    if (n > 0) add(cost, observer_, result_);
    const auto state = z_.template cast<double>().eval();
    if (outcome.failure || !state.allFinite()) {
      result_.failure = {.cause = outcome.failure ? cause_of(*outcome.failure) : Cause::not_finite,
                         .step = n,
                         .t = from_ + outcome.reached * (t - from_),
                         .softest = outcome.softest,
                         .softest_at_rest = workspace_.softest_at_rest,
                         .pushed = {}};
      if (runtime::is_oscillators(*model_)) result_.failure->pushed = outcome.pushed;
      return false;
    }
    begin_.swap(end_);
    from_ = t;
    if (cubature_) {
      runtime::evaluate<Scalar>(model_->force, z_, workspace_.at);
      compare_with_training(cubature_, t, static_cast<double>(workspace_.at.energy), result_);
    }
    observer_.state({.t = t, .z = state, .velocity = Eigen::VectorXd::Zero(state.size()), .acceleration = {}});
    return true;
  }

  const RunResult& result() const { return result_; }

 private:
  const scene::Scene scene_;
  Shared<Scalar> model_;
  const Observer& observer_;
  const std::optional<model::Cubature>& cubature_;
  ReducedLoad load_;
  runtime::StaticWorkspace<Scalar> workspace_;
  Eigen::VectorXd force_;
  runtime::Vector<Scalar> z_, begin_, end_;
  double from_ = 0;
  RunResult result_;
};

/// The steps that all bodies have behind them.
std::int64_t steps_behind(std::span<const Actor> actors) {
  std::optional<std::int64_t> steps;
  for (const auto& actor : actors) {
    const auto* from = std::get_if<Checkpoint>(&actor.start);
    const auto behind = from ? from->steps : 0;
    if (steps.value_or(behind) != behind) throw InputError("the bodies did not stop at the same time");
    steps = behind;
  }
  return steps.value_or(0);
}

/// All bodies from step `first` on, side by side.
template <class Body, class Scalar>
std::vector<RunResult> go(const scene::Scene& scene, std::span<const Actor> actors, std::int64_t first,
                          std::int64_t last) {
  std::map<const model::Body*, Shared<Scalar>> models;
  std::vector<std::unique_ptr<Body>> bodies;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    const auto name = scene.bodies.empty() ? std::string() : scene.bodies[i].name;
    naming(name, [&] {
      auto& model = models[actors[i].body];
      if (!model) model = share(make_model<Scalar>(*actors[i].body, scene.damping));
      bodies.push_back(std::make_unique<Body>(name.empty() ? scene : scene::of_body(scene, name), model, actors[i]));
    });
  }
  for (auto n = first; n <= last; ++n)
    if (!std::ranges::all_of(bodies, [n](const auto& body) { return body->step(n); })) break;
  std::vector<RunResult> results;
  for (const auto& body : bodies) results.push_back(body->result());
  return results;
}

template <class Scalar>
std::vector<RunResult> run_in(const scene::Scene& scene, std::span<const Actor> actors) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis))
    return go<Moving<Scalar>, Scalar>(scene, actors, steps_behind(actors) + 1, scene::step_count(*time));
  return go<Loading<Scalar>, Scalar>(scene, actors, 0, std::get<scene::Static>(scene.analysis).steps);
}

}  // namespace

Cause cause_of(runtime::NoRest failure) {
  switch (failure) {
    case runtime::NoRest::free_body: return Cause::free_body;
    case runtime::NoRest::limit_point: return Cause::limit_point;
    case runtime::NoRest::not_converged: return Cause::not_converged;
    case runtime::NoRest::not_finite: return Cause::not_finite;
  }
  throw std::logic_error("a failure without a cause");
}

std::vector<RunResult> run(const scene::Scene& scene, std::span<const Actor> actors, Precision precision) {
  return precision == Precision::float32 ? run_in<float>(scene, actors) : run_in<double>(scene, actors);
}

RunResult run(const scene::Scene& scene, const model::Body& body, Precision precision, const Observer& observer) {
  const Actor alone{&body, &observer, {}};
  return run(scene, std::span(&alone, 1), precision).front();
}

}  // namespace ritz::world
