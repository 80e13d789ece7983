#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <ostream>
#include <utility>

#include "inside_out.hpp"
#include "ritz/base/counted.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/names.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/scene/room.hpp"
#include "ritz/scene/scene.hpp"
#include "run_analysis.hpp"
#include "run_balance.hpp"
#include "run_body.hpp"
#include "run_frames.hpp"
#include "run_loads.hpp"
#include "run_nonlinear.hpp"

namespace ritz::tools {
namespace {

enum class Tables { none, probes };

/// Takes the names of all that the run will write.
files::Claim claim(const RunOptions& options, Frames frames, Tables tables) {
  const auto& output = options.output;
  files::Plan plan{.outputs = {{"--output " + output.string(), output}},
                   .inputs = {{"the model " + options.model.string(), options.model}}};
  const auto beside = [&](const std::string& what, const std::filesystem::path& path) {
    plan.outputs.push_back({what + " " + path.string() + " beside the output", path});
  };
  if (!options.scene.empty()) plan.inputs.push_back({"the scene " + options.scene.string(), options.scene});
  if (frames == Frames::some) beside("the file", format::xdmf_path(output, "--output " + output.string()));
  if (tables == Tables::probes) beside("the table", files::table_beside(output, "probes"));
  if (!options.timing.empty()) plan.outputs.push_back({"--timing " + options.timing.string(), options.timing});
  return files::Claim(std::move(plan));
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

/// People write percent.
std::string overdamped(const scene::Damping& damping) {
  const auto large = std::ranges::find_if(damping.ratio, [](double ratio) { return ratio >= 1; });
  if (large == damping.ratio.end()) return "";
  return "[damping] ratio " + shown(*large) + " is overdamped, nothing swings: a ratio is a fraction of the critical " +
         "damping, and 2 % is written 0.02";
}

Cost run_analysis(const RunOptions& options, const scene::Scene& scene, const model::Body& body, Recorder& recorder) {
  const Visible progress = options.voice == Voice::quiet ? Visible::no : on_terminal();
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  if (body.polynomial)
    return time ? run_nonlinear_transient(scene, *time, body, options.precision, recorder, progress)
                : run_nonlinear_statics(scene, std::get<scene::Static>(scene.analysis), body, options.precision,
                                        recorder);
  if (options.precision == Precision::single)
    throw InputError("--single is for nonlinear forces, and these are linear: leave it out");
  return time ? run_transient(scene, *time, body, recorder, progress)
              : run_statics(scene, std::get<scene::Static>(scene.analysis), body, recorder);
}

void say_cost(const Cost& cost, const scene::Scene& scene, const model::Body& body, std::ostream& out) {
  const bool timed = std::holds_alternative<scene::Time>(scene.analysis);
  out << cost.steps << (timed ? " steps" : " load steps") << " of " << reduced_size(body) << " coordinates in "
      << std::setprecision(3) << cost.seconds << " s, " << 1e6 * cost.seconds / static_cast<double>(cost.steps)
      << " µs a step; ";
  if (body.polynomial) out << cost.iterations << " Newton iterations, " << cost.rejected << " steps rejected; ";
}

void run_scene(const RunOptions& options, const format::ModelReader& in, std::ostream& out, std::ostream& err) {
  const scene::Scene scene = scene::read(options.scene);
  const std::int64_t steps = count_steps(scene);
  const std::int64_t frames = frame_count(options, steps);
  const auto drawn = frames == 0 ? Frames::none : Frames::some;
  const auto names = claim(options, drawn, scene.probes.empty() ? Tables::none : Tables::probes);
  const model::Body body = read_body(in, scene, drawn, options.forces);
  refuse_rigid_motion(in, scene, body);
  scene::refuse_beyond_room({.steps = steps,
                             .frames = frames,
                             .bytes_a_step = 8.0 * static_cast<double>(1 + reduced_size(body)),
                             .bytes_a_frame = 8.0 * static_cast<double>(body.geometry.points.size())},
                            options.output, std::numeric_limits<double>::infinity());
  const auto frame_states = frame_schedule(options, steps);

  const auto plan = plan_scene(scene, steps, frame_states, reduced_size(body));
  Recorder recorder(options.output, body, plan, frame_states);
  if (!scene.probes.empty()) recorder.add_probes(scene.probes, probe_matrix(scene, body));
  if (!options.timing.empty()) recorder.add_timing(options.timing);

  if (const auto text = overdamped(scene.damping); !text.empty()) err << "ritz-run: warning: " << text << '\n';
  const Cost cost = run_analysis(options, scene, body, recorder);
  recorder.commit(names);
  if (!cost.warning.empty()) err << "ritz-run: warning: " << printable(cost.warning) << '\n';
  if (options.voice == Voice::quiet) return;
  say_cost(cost, scene, body, out);
  out << frame_states.size() << " frames in " << options.output.string() << '\n';
  if (!cost.balance.empty()) out << cost.balance << '\n';
  if (const auto cells = inside_out(body.geometry, recorder.latest()); cells > 0)
    out << counted(cells, "cell is", "cells are") << " inside out at the end\n";
}

void animate(const RunOptions& options, const format::ModelReader& in, std::ostream& out) {
  const auto names = claim(options, Frames::some, Tables::none);
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
  recorder.commit(names);
  if (options.voice == Voice::quiet) return;
  out << "mode " << index + 1 << ", " << frequency << " Hz: " << states << " frames in " << options.output.string()
      << '\n';
}

}  // namespace

void run(const RunOptions& options, std::ostream& out, std::ostream& err) {
  const format::ModelReader in(options.model);
  if (options.animate_mode) animate(options, in, out);
  else run_scene(options, in, out, err);
}

}  // namespace ritz::tools
