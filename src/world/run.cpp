#include "ritz/world/run.hpp"

#include <algorithm>
#include <chrono>

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
RunResult let_pass(const scene::Scene& scene, const scene::Time& time, const model::Body& body,
                   const Observer& observer) {
  const auto model = share(make_model<Scalar>(body, scene.damping));
  const ReducedLoad load = reduce_loads(scene, body);
  Eigen::VectorXd force(model->size());
  load.evaluate(scene, 0, force);
  const auto integrator = choose(time.integrator, *model);
  auto instance = make_instance<Scalar>(model, integrator, Scalar(time.step), force.cast<Scalar>().eval());
  RunResult result{
      .integrator = integrator.name, .steps = scene::step_count(time), .energy = {}, .gain = {}, .failure = {}};
  std::optional<Watch<Scalar>> watch;
  if (!runtime::is_oscillators(*model)) watch.emplace(instance, result.steps);
  observer.state(0, instance.state.z().template cast<double>().eval());
  runtime::Vector<Scalar> end(model->size());
  for (std::int64_t n = 1; n <= result.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) * time.step;
    load.evaluate(scene, t, force);
    end = force.cast<Scalar>();
    const auto outcome = step<Scalar>(instance, end);
    add({t, seconds_since(started), outcome.iterations, outcome.rejected}, observer, result);
    if (outcome.status != runtime::Status::done) {
      if (watch) watch->look(static_cast<double>(n - 1) * time.step);
      const bool finite = outcome.status == runtime::Status::not_converged;
      result.failure = {.cause = finite ? Cause::not_converged : Cause::not_finite, .step = n, .t = t, .pushed = {}};
      break;
    }
    if (watch) watch->after(n, t, outcome);
    observer.state(t, instance.state.z().template cast<double>().eval());
  }
  if (watch) watch->report(result);
  return result;
}

Cause cause_of(runtime::NoRest failure) {
  switch (failure) {
    case runtime::NoRest::free_body: return Cause::free_body;
    case runtime::NoRest::limit_point: return Cause::limit_point;
    case runtime::NoRest::not_converged: return Cause::not_converged;
    case runtime::NoRest::not_finite: return Cause::not_finite;
  }
  throw std::logic_error("a failure without a cause");
}

template <class Scalar>
RunResult load_slowly(const scene::Scene& scene, const scene::Static& statics, const model::Body& body,
                      const Observer& observer) {
  const auto model = make_model<Scalar>(body, scene.damping);
  const ReducedLoad load = reduce_loads(scene, body);
  auto workspace = runtime::make_static_workspace<Scalar>(model);
  Eigen::VectorXd force(model.size());
  runtime::Vector<Scalar> z = runtime::Vector<Scalar>::Zero(model.size()), begin = z, end = z;
  RunResult result{.integrator = {}, .steps = statics.steps, .energy = {}, .gain = {}, .failure = {}};
  double from = 0;
  for (int n = 0; n <= statics.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) / statics.steps;
    load.evaluate(scene, t, force);
    end = force.cast<Scalar>();
    const auto outcome = runtime::solve_static<Scalar>(model, {begin, end}, z, workspace);
    const StepCost cost{t, seconds_since(started), outcome.iterations, outcome.rejected};
    if (n > 0) add(cost, observer, result);
    const auto state = z.template cast<double>().eval();
    if (outcome.failure || !state.allFinite()) {
      result.failure = {.cause = outcome.failure ? cause_of(*outcome.failure) : Cause::not_finite,
                        .step = n,
                        .t = from + outcome.reached * (t - from),
                        .softest = outcome.softest,
                        .softest_at_rest = workspace.softest_at_rest,
                        .pushed = {}};
      if (runtime::is_oscillators(model)) result.failure->pushed = outcome.pushed;
      break;
    }
    begin.swap(end);
    from = t;
    observer.state(t, state);
  }
  return result;
}

template <class Scalar>
RunResult run_in(const scene::Scene& scene, const model::Body& body, const Observer& observer) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis))
    return let_pass<Scalar>(scene, *time, body, observer);
  return load_slowly<Scalar>(scene, std::get<scene::Static>(scene.analysis), body, observer);
}

}  // namespace

RunResult run(const scene::Scene& scene, const model::Body& body, Precision precision, const Observer& observer) {
  return precision == Precision::single ? run_in<float>(scene, body, observer) : run_in<double>(scene, body, observer);
}

}  // namespace ritz::world
