#include "run_nonlinear.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/runtime/nonlinear_statics.hpp"
#include "ritz/runtime/nonlinear_step.hpp"
#include "run_energy.hpp"
#include "run_loads.hpp"
#include "run_timing.hpp"

namespace ritz::tools {
namespace {

template <class Scalar>
runtime::NonlinearModel<Scalar> nonlinear_model(const scene::Scene& scene, const model::Body& body) {
  const auto& [alpha, beta, ratio] = scene.damping;
  return runtime::make_nonlinear_model<Scalar>(*body.polynomial, {.alpha = alpha, .beta = beta, .ratio = ratio});
}

template <class Scalar>
runtime::Method<Scalar> method(const scene::Time& time) {
  switch (time.integrator.value_or(scene::Integrator::avf)) {
    case scene::Integrator::exact: break;
    case scene::Integrator::implicit_euler: return runtime::nonlinear_implicit_euler<Scalar>();
    case scene::Integrator::newmark: return runtime::nonlinear_newmark<Scalar>();
    case scene::Integrator::generalized_alpha: return runtime::nonlinear_generalized_alpha<Scalar>();
    case scene::Integrator::bdf2: return runtime::nonlinear_bdf2<Scalar>();
    case scene::Integrator::central_difference: return runtime::nonlinear_central_difference<Scalar>();
    case scene::Integrator::avf: return runtime::nonlinear_avf<Scalar>();
  }
  throw InputError(
      "the integrator 'exact' is for linear models, and this one is nonlinear: choose avf, implicit-euler, newmark, "
      "generalized-alpha, bdf2 or central-difference, or run it with --linear");
}

/// How often the energy is looked at: it costs an evaluation.
constexpr std::int64_t looks = 200;

std::string why(runtime::Status status) {
  return status == runtime::Status::not_finite ? "is not finite: the loads are too large"
                                               : "does not converge, nor do its halves: take shorter steps";
}

template <class Scalar>
void advance(const scene::Time& time, const ReducedLoad& load, const scene::Scene& scene,
             const runtime::NonlinearModel<Scalar>& model, runtime::NonlinearState<Scalar>& state,
             runtime::NonlinearWorkspace<Scalar>& workspace, Recorder& recorder, Progress& line, EnergyWatch& watch,
             Cost& cost) {
  Eigen::VectorXd force(model.size());
  load.evaluate(scene, 0, force);
  runtime::Vector<Scalar> begin = force.cast<Scalar>(), end = begin;
  const std::int64_t every = std::max<std::int64_t>(1, cost.steps / looks);
  for (std::int64_t n = 1; n <= cost.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) * time.step;
    load.evaluate(scene, t, force);
    end = force.cast<Scalar>();
    const auto outcome = runtime::step<Scalar>(model, state, {begin, end}, Scalar(time.step), workspace);
    const StepCost spent{t, seconds_since(started), outcome.iterations, outcome.rejected};
    cost.add(spent);
    recorder.cost(spent);
    if (outcome.status != runtime::Status::done) {
      watch.look(static_cast<double>(n - 1) * time.step, runtime::energy(model, state, workspace.at_point));
      const auto gained = watch.warning(std::string(workspace.method.name));
      throw NumericalError("step " + std::to_string(n) + ", t = " + std::to_string(t) + " s, " + why(outcome.status) +
                           (gained.empty() ? "" : "; " + gained));
    }
    watch.add_work(outcome.work - outcome.dissipated);
    if (n % every == 0 || n == cost.steps) watch.look(t, runtime::energy(model, state, workspace.at_point));
    begin.swap(end);
    recorder.record(t, state.z().template cast<double>().eval());
    line.at(n);
  }
}

template <class Scalar>
Cost transient(const scene::Scene& scene, const scene::Time& time, const model::Body& body, Recorder& recorder,
               Visible progress) {
  const auto rule = method<Scalar>(time);
  const auto model = nonlinear_model<Scalar>(scene, body);
  const ReducedLoad load = reduce_loads(scene, body);
  Eigen::VectorXd force(model.size());
  load.evaluate(scene, 0, force);
  const runtime::Vector<Scalar> rest = runtime::Vector<Scalar>::Zero(model.size());
  auto workspace = runtime::make_workspace<Scalar>(model, rule, Scalar(time.step));
  auto state = runtime::make_state<Scalar>(model, rule.history, rest, rest, force.cast<Scalar>().eval());
  Cost cost{.steps = scene::step_count(time)};
  Progress line(cost.steps, progress);
  EnergyWatch watch(0);
  recorder.record(0, rest.template cast<double>().eval());
  advance(time, load, scene, model, state, workspace, recorder, line, watch, cost);
  cost.balance = watch.balance();
  cost.warning = watch.warning(std::string(rule.name));
  return cost;
}

template <class Scalar>
Cost statics_of(const scene::Scene& scene, const scene::Static& statics, const model::Body& body, Recorder& recorder) {
  const auto model = nonlinear_model<Scalar>(scene, body);
  const ReducedLoad load = reduce_loads(scene, body);
  auto workspace = runtime::make_static_workspace<Scalar>(model);
  Eigen::VectorXd force(model.size());
  runtime::Vector<Scalar> z = runtime::Vector<Scalar>::Zero(model.size()), begin = z, end = z;
  Cost cost{.steps = statics.steps};
  double from = 0;
  for (int n = 0; n <= statics.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) / statics.steps;
    load.evaluate(scene, t, force);
    end = force.cast<Scalar>();
    const auto outcome = runtime::solve_static<Scalar>(model, {begin, end, from, t}, z, workspace);
    const StepCost spent{t, seconds_since(started), outcome.iterations, outcome.rejected};
    if (n > 0) {
      cost.add(spent);
      recorder.cost(spent);
    }
    begin.swap(end);
    from = t;
    recorder.record(t, z.template cast<double>().eval());
  }
  return cost;
}

}  // namespace

Cost run_nonlinear_transient(const scene::Scene& scene, const scene::Time& time, const model::Body& body,
                             Precision precision, Recorder& recorder, Visible progress) {
  return precision == Precision::single ? transient<float>(scene, time, body, recorder, progress)
                                        : transient<double>(scene, time, body, recorder, progress);
}

Cost run_nonlinear_statics(const scene::Scene& scene, const scene::Static& statics, const model::Body& body,
                           Precision precision, Recorder& recorder) {
  return precision == Precision::single ? statics_of<float>(scene, statics, body, recorder)
                                        : statics_of<double>(scene, statics, body, recorder);
}

}  // namespace ritz::tools
