#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <ostream>
#include <utility>

#include "play.hpp"
#include "progress.hpp"
#include "ritz/base/error.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/json.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/scene_file/read.hpp"
#include "ritz/scene_file/room.hpp"
#include "ritz/world/loads.hpp"
#include "run_body.hpp"
#include "run_recorder.hpp"
#include "run_report.hpp"
#include "run_start.hpp"

namespace ritz::tools {
namespace {

enum class Tables { none, probes };

std::filesystem::path output_of(const RunOptions& options, const RunBody& body) {
  return motion_of(options.output, "--output", body);
}

/// Takes the names of all that the run will write.
files::Claim claim(const RunOptions& options, const std::vector<RunBody>& bodies, Frames frames, Tables tables) {
  files::Plan plan{.outputs = {}};
  const auto beside = [&](const std::string& what, const std::filesystem::path& path) {
    plan.outputs.push_back({what + " " + path.string() + " beside the output", path});
  };
  for (const auto& body : bodies) {
    const auto output = output_of(options, body);
    plan.outputs.push_back({"--output " + output.string(), output});
    if (frames == Frames::some) beside("the file", format::xdmf_path(output, "--output " + output.string()));
    const files::Named model{"the model " + body.model_file.string(), body.model_file};
    const auto same = [&](const files::Named& input) { return input.path == model.path; };
    if (std::ranges::none_of(plan.inputs, same)) plan.inputs.push_back(model);
    if (!options.restart.empty()) {
      const auto earlier = motion_of(options.restart, "--restart", body);
      (bodies.size() == 1 ? plan.replaceable : plan.inputs).push_back({"--restart " + earlier.string(), earlier});
    } else if (const auto start = stored_start(body)) {
      plan.inputs.push_back(*start);
    }
  }
  if (!options.scene.empty()) plan.inputs.push_back({"the scene " + options.scene.string(), options.scene});
  if (tables == Tables::probes) beside("the table", files::table_beside(options.output, "probes"));
  if (!options.timing.empty()) plan.outputs.push_back({"--timing " + options.timing.string(), options.timing});
  if (!options.summary.empty()) plan.outputs.push_back({"--summary " + options.summary.string(), options.summary});
  return files::Claim(std::move(plan));
}

/// The steps of a scene that a run makes: from the state after step `first` to that after step `last`.
struct Steps {
  std::int64_t first, last;

  std::int64_t count() const { return last - first; }
};

MotionPlan plan_scene(const RunBody& body, const Steps& steps, const std::vector<std::int64_t>& frame_states) {
  const auto* time = std::get_if<scene::Time>(&body.scene.analysis);
  MotionPlan plan{.states = steps.count() + 1,
                  .columns = world::reduced_size(*body.model),
                  .frame_times = {},
                  .time_units = time ? "s" : "1",
                  .model_checksum = body.coordinates};
  for (const auto state : frame_states) {
    const auto n = static_cast<double>(steps.first + state);
    plan.frame_times.push_back(time ? n * time->step : n / static_cast<double>(steps.last));
  }
  return plan;
}

std::int64_t count_steps(const scene::Scene& scene) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) return scene::step_count(*time);
  return std::get<scene::Static>(scene.analysis).steps;
}

scene::FrameChoice chosen_frames(const RunOptions& options) { return {options.frames, options.every}; }

void refuse_unfit(const RunOptions& options, const RunBody& body) {
  const auto* time = std::get_if<scene::Time>(&body.scene.analysis);
  if (const auto left_out = world::left_out_motions(body.scene, *body.model))
    refuse(*left_out, body.model_file.string());
  const bool nonlinear = is_nonlinear(*body.model);
  if (nonlinear && time && time->integrator == scene::Integrator::exact)
    throw InputError(
        "the integrator 'exact' is for linear models, and this one is nonlinear: choose avf, implicit-euler, newmark, "
        "generalized-alpha, linearly-implicit, bdf2 or central-difference, or run it with --linear");
  if (!nonlinear && options.precision == world::Precision::float32)
    throw InputError("--single is for nonlinear forces, and these are linear: leave it out");
}

void refuse_beyond_room(const RunOptions& options, const std::vector<RunBody>& bodies, std::int64_t steps,
                        std::int64_t frames) {
  scene::Recording recording{.steps = steps, .frames = frames, .bytes_a_step = 0, .bytes_a_frame = 0};
  for (const auto& body : bodies) {
    recording.bytes_a_step += 8.0 * static_cast<double>(1 + 2 * world::reduced_size(*body.model));
    recording.bytes_a_frame += (options.frame_numbers == format::Stored::float32 ? 4.0 : 8.0) *
                               static_cast<double>(body.model->geometry.points.size());
  }
  scene::refuse_beyond_room(recording, options.output, std::numeric_limits<double>::infinity());
}

/// What a run's bodies leave behind, all files open.
void prepare(Recorder& recorder, const RunOptions& options, const scene::Scene& scene,
             const std::vector<RunBody>& bodies, const Steps& steps, const std::vector<std::int64_t>& frame_states) {
  std::vector<ProbedBody> probed;
  for (const auto& body : bodies) {
    auto plan = plan_scene(body, steps, frame_states);
    plan.frames = options.frame_numbers;
    recorder.add(output_of(options, body), *body.model, plan);
    if (scene.probes.empty()) continue;
    world::naming(body.name, [&] { probed.push_back({body.name, world::probe_matrix(body.scene, *body.model)}); });
  }
  if (!scene.probes.empty())
    recorder.add_probes(files::table_beside(options.output, "probes"), scene.probes, std::move(probed));
  if (!options.timing.empty()) recorder.add_timing(options.timing);
  if (!options.summary.empty()) recorder.add_summary(options.summary);
}

/// Runs to the end; every state goes to the recorder, if there is one, and to the listener.
std::vector<world::RunResult> run_to_end(const RunOptions& options, const scene::Scene& scene,
                                         const std::vector<RunBody>& bodies, std::vector<world::Start> starts,
                                         const Steps& steps, Recorder* recorder, const Listener& listener) {
  Progress line(steps.count(), options.voice == Voice::quiet ? Visible::no : on_terminal());
  std::int64_t states = 0;
  std::vector<world::Observer> observers;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    observers.push_back({.state =
                             [&, i](const world::Moment& now) {
                               if (recorder) recorder->record(i, now);
                               if (listener.state) listener.state(i, now.t, now.z);
                               if (i == 0) line.at(states++);
                             },
                         .cost =
                             [&, i](const world::StepCost& cost) {
                               if (recorder) recorder->cost(i, cost);
                             }});
  std::vector<world::Actor> actors;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    actors.push_back({bodies[i].model.get(), &observers[i], std::move(starts[i])});
  auto results = world::run(scene, actors, options.precision);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (results[i].failure) fail(results[i], bodies[i]);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (recorder && results[i].last) recorder->keep(i, end_of(options, bodies[i], results[i]));
  return results;
}

void say(const BodyResult& of, const scene::Scene& scene, std::int64_t frames, Voice voice, std::ostream& out) {
  const auto& [body, result, output, inverted] = of;
  const bool timed = std::holds_alternative<scene::Time>(scene.analysis);
  out << who(body) << result.steps << (timed ? " steps" : " load steps") << " of " << world::reduced_size(*body.model)
      << " coordinates in " << std::setprecision(3) << result.seconds << " s, "
      << 1e6 * result.seconds / static_cast<double>(result.steps) << " µs a step; ";
  const bool nonlinear = is_nonlinear(*body.model), details = voice == Voice::verbose;
  if (nonlinear && details) out << result.iterations << " Newton iterations, ";
  if (nonlinear && (result.rejected > 0 || details))
    out << counted(result.rejected, "attempt", "attempts") << " did not converge and went on in halves; ";
  out << frames << " frames in " << output.string() << '\n';
  if (result.energy) out << who(body) << balance_line(*result.energy) << '\n';
  if (result.errors) out << who(body) << error_line(*result.errors) << '\n';
  if (inverted > 0) out << who(body) << counted(inverted, "cell is", "cells are") << " inside out at the end\n";
}

void say_replaced(const std::string& files, std::ostream& out) {
  if (!files.empty()) out << files << '\n';
}

/// ψ sin ωt over one period of `frequency` Hz at `states` times, from 0; the period's end is its beginning and not
/// repeated.
void swing_mode(const model::Body& body, double frequency, std::int64_t states, Recorder& recorder) {
  const auto& points = body.geometry.points;
  const double diagonal = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const Eigen::Map<const model::Points> shape(body.basis.U.data(), points.rows(), 3);
  const double largest = shape.rowwise().norm().maxCoeff();
  const double amplitude = format::factor_for_the_eye(largest, diagonal);
  for (std::int64_t k = 0; k < states; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(states), omega = 2 * M_PI * frequency;
    recorder.record(0, {.t = turn / frequency,
                        .z = Eigen::VectorXd::Constant(1, amplitude * std::sin(2 * M_PI * turn)),
                        .velocity = Eigen::VectorXd::Constant(1, amplitude * omega * std::cos(2 * M_PI * turn)),
                        .acceleration = {}});
  }
}

void run_scene(const RunOptions& options, std::ostream& out, std::ostream& err) {
  const scene::Scene scene = scene::read(options.scene);
  const auto warn = [&](const std::string& text) { err << "ritz-run: warning: " << text << '\n'; };
  const auto played = play(options, scene, cast(scene, options.model), Files::written, {.warning = warn, .state = {}});
  if (options.voice == Voice::quiet) return;
  say_replaced(played.replaced, out);
  for (const auto& body : played.bodies) say(body, scene, played.frames, options.voice, out);
}

void animate(const RunOptions& options, std::ostream& out) {
  const format::ModelReader in(options.model);
  const auto names =
      claim(options, {{.name = {}, .model_file = options.model, .scene = {}, .model = {}, .coordinates = {}}},
            Frames::some, Tables::none);
  const std::int64_t index = *options.animate_mode - 1;
  const model::Body body = read_mode(in, index);
  const auto& kinds = body.modes->kinds;
  if (kinds[static_cast<std::size_t>(index)] == model::ModeKind::rigid) {
    const auto flexible = std::find(kinds.begin(), kinds.end(), model::ModeKind::flexible) - kinds.begin();
    throw InputError("mode " + std::to_string(index + 1) + " is rigid and does not swing; the flexible ones start at " +
                     std::to_string(flexible + 1));
  }
  const double frequency = model::frequency(body.modes->eigenvalues[index]);
  const std::int64_t states = options.frames.value_or(40);
  if (states < 1) throw InputError("--animate-mode needs at least one frame: --frames 0 leaves nothing to see");

  MotionPlan plan{
      .states = states, .columns = 1, .frame_times = {}, .time_units = "s", .frames = options.frame_numbers};
  std::vector<std::int64_t> frame_states(static_cast<std::size_t>(states));
  std::iota(frame_states.begin(), frame_states.end(), 0);
  for (const auto k : frame_states)
    plan.frame_times.push_back(static_cast<double>(k) / static_cast<double>(states) / frequency);
  Recorder recorder(frame_states);
  recorder.add(options.output, body, plan);
  swing_mode(body, frequency, states, recorder);
  recorder.commit(names);
  if (options.voice == Voice::quiet) return;
  say_replaced(names.replaced(), out);
  out << "mode " << index + 1 << ", " << frequency << " Hz: " << states << " frames in " << options.output.string()
      << '\n';
}

}  // namespace

Played play(const RunOptions& options, const scene::Scene& scene, std::vector<RunBody> bodies, Files files,
            const Listener& listener) {
  const bool written = files == Files::written;
  const auto drawn = options.frames == 0 ? Frames::none : Frames::some;
  std::optional<files::Claim> names;
  if (written) names.emplace(claim(options, bodies, drawn, scene.probes.empty() ? Tables::none : Tables::probes));
  read_bodies(bodies, scene, written ? drawn : Frames::some, options.forces);  // a listener may want to draw
  for (const auto& body : bodies) world::naming(body.name, [&] { refuse_unfit(options, body); });
  auto from = starts(options, bodies);
  const Steps steps{.first = steps_behind(from), .last = count_steps(scene)};
  const std::int64_t frames = written ? scene::frame_count(chosen_frames(options), steps.count()) : 0;
  std::optional<Recorder> recorder;
  if (written) {
    refuse_beyond_room(options, bodies, steps.count(), frames);
    const auto frame_states = scene::frame_schedule(chosen_frames(options), steps.count());
    prepare(recorder.emplace(frame_states), options, scene, bodies, steps, frame_states);
  }

  std::vector<std::string> warnings;
  if (const auto text = overdamped(scene.damping); !text.empty()) {
    listener.warning(text);
    warnings.push_back(text);
  }
  const auto results =
      run_to_end(options, scene, bodies, std::move(from), steps, recorder ? &*recorder : nullptr, listener);
  const auto said_before = warnings.size();
  const bool told = written && (options.voice != Voice::quiet || !options.summary.empty());
  Played played{.bodies = {}, .frames = frames, .replaced = {}};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    played.bodies.push_back({.body = bodies[i],
                             .result = results[i],
                             .output = written ? output_of(options, bodies[i]) : "",
                             .inverted_cells = told ? inside_out(bodies[i].model->geometry, recorder->latest(i)) : 0});
    const std::string integrator(results[i].integrator);
    if (results[i].beyond) warnings.push_back(who(bodies[i]) + warning(*results[i].beyond, scene));
    if (results[i].gain) warnings.push_back(who(bodies[i]) + warning(*results[i].gain, integrator));
    if (const auto text = results[i].errors ? too_long(*results[i].errors, integrator) : ""; !text.empty())
      warnings.push_back(who(bodies[i]) + text);
  }
  if (written && !options.summary.empty())
    recorder->summary(files::json_text(summary(
        {.options = options, .scene = scene, .bodies = played.bodies, .frames = frames, .warnings = warnings})));
  if (written) {
    recorder->commit(*names);
    played.replaced = names->replaced();
  }
  for (auto i = said_before; i < warnings.size(); ++i) listener.warning(warnings[i]);
  return played;
}

void run(const RunOptions& options, std::ostream& out, std::ostream& err) {
  if (options.animate_mode) animate(options, out);
  else run_scene(options, out, err);
}

}  // namespace ritz::tools
