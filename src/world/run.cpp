#include "ritz/world/run.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <utility>

#include "ritz/world/loads.hpp"

namespace ritz::world {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// How often the energy is looked at: it costs an evaluation.
constexpr std::int64_t looks = 200;

void add(const StepCost& cost, const Observer& observer, RunResult& result) {
  result.seconds += cost.seconds;
  result.iterations += cost.iterations;
  result.rejected += cost.rejected;
  observer.cost(cost);
}

/// Looks at the energy of a nonlinear motion, now and then.
template <class Scalar>
class Watch {
 public:
  Watch(const Instance<Scalar>& instance, std::int64_t steps)
      : instance_(instance),
        every_(std::max<std::int64_t>(1, steps / looks)),
        steps_(steps),
        room_(runtime::make_evaluation(instance.model->force)) {}

  void after(std::int64_t n, double t, const runtime::Outcome& outcome) {
    watch_.add(outcome.work, outcome.dissipated);
    if (n % every_ == 0 || n == steps_) look(t);
  }
  void look(double t) {
    watch_.look(t, static_cast<double>(runtime::energy(*instance_.model, instance_.state, room_)));
  }
  void report(RunResult& result) const {
    result.energy = watch_.balance();
    result.gain = watch_.gain();
  }

 private:
  const Instance<Scalar>& instance_;
  std::int64_t every_, steps_;
  runtime::Evaluation<Scalar> room_;
  EnergyWatch watch_{0};
};

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
        load_(reduce_loads(scene, *actor.body)),
        force_(model->size()),
        end_(model->size()) {
    load_.evaluate(scene_, 0, force_);
    const auto integrator = choose(time_.integrator, *model);
    instance_ = make_instance<Scalar>(model, integrator, Scalar(time_.step), force_.cast<Scalar>().eval());
    result_.integrator = integrator.name;
    result_.steps = scene::step_count(time_);
    if (!runtime::is_oscillators(*model)) watch_.emplace(instance_, result_.steps);
    observer_.state(0, instance_.state.z().template cast<double>().eval());
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
      if (watch_) watch_->look(static_cast<double>(n - 1) * time_.step);
      const bool finite = outcome.status == runtime::Status::not_converged;
      result_.failure = {.cause = finite ? Cause::not_converged : Cause::not_finite, .step = n, .t = t, .pushed = {}};
      return false;
    }
    if (watch_) watch_->after(n, t, outcome);
    observer_.state(t, instance_.state.z().template cast<double>().eval());
    return true;
  }

  RunResult result() const {
    auto result = result_;
    if (watch_) watch_->report(result);
    return result;
  }

 private:
  const scene::Scene scene_;
  const scene::Time time_;
  const Observer& observer_;
  ReducedLoad load_;
  Eigen::VectorXd force_;
  runtime::Vector<Scalar> end_;
  Instance<Scalar> instance_;
  std::optional<Watch<Scalar>> watch_;
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
    observer_.state(t, state);
    return true;
  }

  const RunResult& result() const { return result_; }

 private:
  const scene::Scene scene_;
  Shared<Scalar> model_;
  const Observer& observer_;
  ReducedLoad load_;
  runtime::StaticWorkspace<Scalar> workspace_;
  Eigen::VectorXd force_;
  runtime::Vector<Scalar> z_, begin_, end_;
  double from_ = 0;
  RunResult result_;
};

/// All bodies from step `first` to the last, side by side.
template <class Body, class Scalar>
std::vector<RunResult> go(const scene::Scene& scene, std::span<const Actor> actors, std::int64_t first) {
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
  const auto last = bodies.empty() ? 0 : bodies.front()->result().steps;
  for (auto n = first; n <= last; ++n)
    if (!std::ranges::all_of(bodies, [n](const auto& body) { return body->step(n); })) break;
  std::vector<RunResult> results;
  for (const auto& body : bodies) results.push_back(body->result());
  return results;
}

template <class Scalar>
std::vector<RunResult> run_in(const scene::Scene& scene, std::span<const Actor> actors) {
  if (std::holds_alternative<scene::Time>(scene.analysis)) return go<Moving<Scalar>, Scalar>(scene, actors, 1);
  return go<Loading<Scalar>, Scalar>(scene, actors, 0);
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
  const Actor alone{&body, &observer};
  return run(scene, std::span(&alone, 1), precision).front();
}

}  // namespace ritz::world
