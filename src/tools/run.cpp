#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <ostream>

#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/scene/scene.hpp"
#include "run_analysis.hpp"
#include "run_body.hpp"
#include "run_frames.hpp"
#include "run_loads.hpp"

namespace ritz::tools {
namespace {

void protect_inputs(const RunOptions& options) {
  std::error_code none;
  for (const auto& input : {options.model, options.scene})
    if (std::filesystem::equivalent(input, options.output, none))
      throw InputError("--output " + options.output.string() + " would overwrite an input: choose another name");
}

MotionPlan plan_scene(const scene::Scene& scene, std::int64_t steps, const std::vector<std::int64_t>& frame_states,
                      Eigen::Index columns) {
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  MotionPlan plan{.states = steps + 1, .columns = columns, .frame_times = {}, .time_units = time ? "s" : "1"};
  for (const auto state : frame_states) {
    const auto n = static_cast<double>(state);
    plan.frame_times.push_back(time ? n * time->step : n / static_cast<double>(steps));
  }
  return plan;
}

std::int64_t count_steps(const scene::Scene& scene) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) return scene::step_count(*time);
  return std::get<scene::Static>(scene.analysis).steps;
}

void run_scene(const RunOptions& options, const format::ModelReader& in, std::ostream& out) {
  const scene::Scene scene = scene::read(options.scene);
  const std::int64_t steps = count_steps(scene);
  const auto frame_states = frame_schedule(options, steps);
  const model::Body body = read_body(in, scene, frame_states.empty() ? Frames::none : Frames::some);

  const auto plan = plan_scene(scene, steps, frame_states, body.modes->eigenvalues.size());
  Recorder recorder(options.output, body, plan, frame_states);
  if (!scene.probes.empty()) recorder.add_probes(scene.probes, probe_matrix(scene, body));

  const Visible progress = options.voice == Voice::quiet ? Visible::no : on_terminal();
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  const Cost cost = time ? run_transient(scene, *time, body, recorder, progress)
                         : run_statics(scene, std::get<scene::Static>(scene.analysis), body, recorder);
  recorder.commit();
  if (options.voice == Voice::quiet) return;
  out << cost.steps << (time ? " steps" : " load steps") << " of " << plan.columns << " coordinates in "
      << std::setprecision(3) << cost.seconds << " s, " << 1e6 * cost.seconds / static_cast<double>(cost.steps)
      << " µs a step; " << frame_states.size() << " frames in " << options.output.string() << '\n';
}

void animate(const RunOptions& options, const format::ModelReader& in, std::ostream& out) {
  const std::int64_t index = *options.animate_mode - 1;
  const model::Body body = read_mode(in, index);
  const auto& kinds = body.modes->kinds;
  if (kinds[static_cast<std::size_t>(index)] == model::ModeKind::rigid) {
    const auto flexible = std::find(kinds.begin(), kinds.end(), model::ModeKind::flexible) - kinds.begin();
    throw InputError("mode " + std::to_string(index + 1) + " is rigid and does not swing; the flexible ones start at " +
                     std::to_string(flexible + 1));
  }
  const double frequency = std::sqrt(body.modes->eigenvalues[index]) / (2 * M_PI);
  const std::int64_t states = options.frames.value_or(40);
  if (states < 1) throw InputError("--animate-mode needs at least one frame: --frames 0 leaves nothing to see");

  MotionPlan plan{.states = states, .columns = 1, .frame_times = {}, .time_units = "s"};
  std::vector<std::int64_t> frame_states(static_cast<std::size_t>(states));
  std::iota(frame_states.begin(), frame_states.end(), 0);
  for (const auto k : frame_states)
    plan.frame_times.push_back(static_cast<double>(k) / static_cast<double>(states) / frequency);
  Recorder recorder(options.output, body, plan, frame_states);
  swing_mode(body, frequency, states, recorder);
  recorder.commit();
  if (options.voice == Voice::quiet) return;
  out << "mode " << index + 1 << ", " << frequency << " Hz: " << states << " frames in " << options.output.string()
      << '\n';
}

}  // namespace

void run(const RunOptions& options, std::ostream& out) {
  const format::ModelReader in(options.model);
  protect_inputs(options);
  if (options.animate_mode) animate(options, in, out);
  else run_scene(options, in, out);
}

}  // namespace ritz::tools
