#include "run_analysis.hpp"

#include <cmath>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/runtime/integrators.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/runtime/step.hpp"
#include "run_loads.hpp"
#include "run_timing.hpp"

namespace ritz::tools {
namespace {

runtime::Oscillators oscillators(const scene::Scene& scene, const model::Body& body) {
  const auto& [alpha, beta, ratio] = scene.damping;
  const runtime::Damping damping{.alpha = alpha, .beta = beta, .ratio = ratio};
  return body.reduction ? runtime::make_oscillators(*body.reduction, damping)
                        : runtime::make_oscillators(*body.modes, damping);
}

runtime::Integrator integrator(const scene::Time& time) {
  switch (time.integrator.value_or(scene::Integrator::exact)) {
    case scene::Integrator::exact: return runtime::exact();
    case scene::Integrator::implicit_euler: return runtime::implicit_euler();
    case scene::Integrator::newmark: return runtime::newmark();
    case scene::Integrator::generalized_alpha: return runtime::generalized_alpha();
    case scene::Integrator::bdf2: return runtime::bdf2();
    case scene::Integrator::central_difference: return runtime::central_difference();
    case scene::Integrator::avf: return runtime::avf();
  }
  throw std::logic_error("an integrator without a name");
}

void require_finite(bool finite, const std::string& what, std::int64_t step, double t) {
  if (!finite)
    throw NumericalError(what + " " + std::to_string(step) + ", t = " + std::to_string(t) +
                         ", is not finite: the loads are too large for double precision");
}

}  // namespace

void Cost::add(const StepCost& step) {
  seconds += step.seconds;
  iterations += step.iterations;
  rejected += step.rejected;
}

Cost run_transient(const scene::Scene& scene, const scene::Time& time, const model::Body& body, Recorder& recorder,
                   Visible progress) {
  const auto model = oscillators(scene, body);
  const auto method = integrator(time);
  const ReducedLoad load = reduce_loads(scene, body);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.size());
  Eigen::VectorXd begin(model.size()), end(model.size());
  load.evaluate(scene, 0, begin);
  auto state = runtime::make_state(model, method, rest, rest, begin);
  auto workspace = runtime::make_workspace(model, method, time.step);

  Cost cost{.steps = scene::step_count(time)};
  Progress line(cost.steps, progress);
  recorder.record(0, state.z());
  for (std::int64_t n = 1; n <= cost.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) * time.step;
    load.evaluate(scene, t, end);
    const auto outcome = runtime::step(model, state, {begin, end}, time.step, workspace);
    const StepCost spent{.t = t, .seconds = seconds_since(started)};
    cost.add(spent);
    recorder.cost(spent);
    require_finite(outcome.status == runtime::Status::done, "step", n, t);
    begin.swap(end);
    recorder.record(t, state.z());
    line.at(n);
  }
  return cost;
}

Cost run_statics(const scene::Scene& scene, const scene::Static& statics, const model::Body& body, Recorder& recorder) {
  const auto model = oscillators(scene, body);
  const ReducedLoad load = reduce_loads(scene, body);
  Eigen::VectorXd force(model.size());
  Cost cost{.steps = statics.steps};
  for (int n = 0; n <= statics.steps; ++n) {
    const auto started = Clock::now();
    const double t = static_cast<double>(n) / statics.steps;
    load.evaluate(scene, t, force);
    const Eigen::VectorXd z = runtime::solve_static(model, force);
    const StepCost spent{.t = t, .seconds = seconds_since(started)};
    if (n > 0) {
      cost.add(spent);
      recorder.cost(spent);
    }
    require_finite(z.allFinite(), "load step", n, t);
    recorder.record(t, z);
  }
  return cost;
}

void swing_mode(const model::Body& body, double frequency, std::int64_t states, Recorder& recorder) {
  const auto& points = body.geometry.points;
  const double diagonal = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const Eigen::Map<const model::Points> shape(body.basis.U.data(), points.rows(), 3);
  const double largest = shape.rowwise().norm().maxCoeff();
  const double amplitude = largest > 0 ? 0.1 * diagonal / largest : 1;
  for (std::int64_t k = 0; k < states; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(states);
    const Eigen::VectorXd z = Eigen::VectorXd::Constant(1, amplitude * std::sin(2 * M_PI * turn));
    recorder.record(turn / frequency, z);
  }
}

}  // namespace ritz::tools
