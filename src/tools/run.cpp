#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <ostream>
#include <utility>

#include "inside_out.hpp"
#include "progress.hpp"
#include "ritz/base/counted.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/json.hpp"
#include "ritz/files/names.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/scene_file/read.hpp"
#include "ritz/scene_file/room.hpp"
#include "ritz/world/loads.hpp"
#include "run_body.hpp"
#include "run_frames.hpp"
#include "run_recorder.hpp"
#include "run_summary.hpp"
#include "run_text.hpp"

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
  if (!options.summary.empty()) plan.outputs.push_back({"--summary " + options.summary.string(), options.summary});
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

void refuse_unfit(const RunOptions& options, const scene::Scene& scene, const model::Body& body) {
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  if (body.polynomial && time && time->integrator == scene::Integrator::exact)
    throw InputError(
        "the integrator 'exact' is for linear models, and this one is nonlinear: choose avf, implicit-euler, newmark, "
        "generalized-alpha, bdf2 or central-difference, or run it with --linear");
  if (!body.polynomial && options.precision == world::Precision::single)
    throw InputError("--single is for nonlinear forces, and these are linear: leave it out");
}

world::RunResult run_recorded(const RunOptions& options, const scene::Scene& scene, const model::Body& body,
                              Recorder& recorder) {
  Progress line(count_steps(scene), options.voice == Voice::quiet ? Visible::no : on_terminal());
  std::int64_t states = 0;
  const auto result = world::run(scene, body, options.precision,
                                 {.state =
                                      [&](double t, const auto& z) {
                                        recorder.record(t, z);
                                        line.at(states++);
                                      },
                                  .cost = [&](const world::StepCost& cost) { recorder.cost(cost); }});
  if (result.failure) fail(result, scene, body);
  return result;
}

void say_cost(const world::RunResult& cost, const scene::Scene& scene, const model::Body& body, std::ostream& out) {
  const bool timed = std::holds_alternative<scene::Time>(scene.analysis);
  out << cost.steps << (timed ? " steps" : " load steps") << " of " << world::reduced_size(body) << " coordinates in "
      << std::setprecision(3) << cost.seconds << " s, " << 1e6 * cost.seconds / static_cast<double>(cost.steps)
      << " µs a step; ";
  if (body.polynomial) out << cost.iterations << " Newton iterations, " << cost.rejected << " steps rejected; ";
}

/// ψ sin ωt over one period of `frequency` Hz at `states` times, from 0; the period's end is its beginning and not
/// repeated. The largest displacement is a tenth of the diagonal of the body's bounding box.
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

void run_scene(const RunOptions& options, const format::ModelReader& in, std::ostream& out, std::ostream& err) {
  const scene::Scene scene = scene::read(options.scene);
  const std::int64_t steps = count_steps(scene);
  const std::int64_t frames = frame_count(options, steps);
  const auto drawn = frames == 0 ? Frames::none : Frames::some;
  const auto names = claim(options, drawn, scene.probes.empty() ? Tables::none : Tables::probes);
  const model::Body body = read_body(in, scene, drawn, options.forces);
  if (const auto left_out = world::left_out_motions(scene, body)) refuse(*left_out, in.name());
  refuse_unfit(options, scene, body);
  scene::refuse_beyond_room({.steps = steps,
                             .frames = frames,
                             .bytes_a_step = 8.0 * static_cast<double>(1 + world::reduced_size(body)),
                             .bytes_a_frame = 8.0 * static_cast<double>(body.geometry.points.size())},
                            options.output, std::numeric_limits<double>::infinity());
  const auto frame_states = frame_schedule(options, steps);

  const auto plan = plan_scene(scene, steps, frame_states, world::reduced_size(body));
  Recorder recorder(options.output, body, plan, frame_states);
  if (!scene.probes.empty()) recorder.add_probes(scene.probes, world::probe_matrix(scene, body));
  if (!options.timing.empty()) recorder.add_timing(options.timing);
  if (!options.summary.empty()) recorder.add_summary(options.summary);

  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    err << "ritz-run: warning: " << text << '\n';
    warnings.push_back(text);
  };
  if (const auto text = overdamped(scene.damping); !text.empty()) warn(text);
  const auto result = run_recorded(options, scene, body, recorder);
  const bool told = options.voice == Voice::normal || !options.summary.empty();
  const auto inverted = told ? inside_out(body.geometry, recorder.latest()) : 0;
  if (result.gain) warnings.push_back(warning(*result.gain, std::string(result.integrator)));
  if (!options.summary.empty())
    recorder.summary(files::json_text(summary({.options = options,
                                               .scene = scene,
                                               .body = body,
                                               .result = result,
                                               .frames = std::ssize(frame_states),
                                               .inverted_cells = inverted,
                                               .warnings = warnings})));
  recorder.commit(names);
  if (result.gain) err << "ritz-run: warning: " << warnings.back() << '\n';
  if (options.voice == Voice::quiet) return;
  say_cost(result, scene, body, out);
  out << frame_states.size() << " frames in " << options.output.string() << '\n';
  if (result.energy) out << balance_line(*result.energy) << '\n';
  if (inverted > 0) out << counted(inverted, "cell is", "cells are") << " inside out at the end\n";
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
