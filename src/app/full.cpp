#include "ritz/app/program.hpp"

#include <algorithm>

#include "ritz/app/full_file.hpp"
#include "ritz/app/full_recorder.hpp"
#include "ritz/app/full_start.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/provenance.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/app/summary.hpp"
#include "ritz/app/warnings.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene_file/room.hpp"

namespace ritz::app {
namespace {

FullPlan plan(const scene::Scene& scene, std::vector<double> times, const std::vector<std::int64_t>& frames) {
  FullPlan plan;
  for (const auto state : frames) plan.frame_times.push_back(times[static_cast<std::size_t>(state)]);
  plan.times = std::move(times);
  plan.time_units = std::holds_alternative<scene::Time>(scene.analysis) ? "s" : "1";
  return plan;
}

/// What takes the state after each step.
using Reached = std::function<void(const stages::DynamicState&, const Effort& so_far)>;

FullResult run_statics(stages::FullModel& model, const scene::Scene& scene, const stages::DynamicState& start,
                       const stages::LoadAt& load, FullRecorder& recorder, const Reached& reached) {
  const stages::StaticOptions options{.steps = std::get<scene::Static>(scene.analysis).steps};
  stages::DynamicState state = start;
  recorder.start(state);
  const auto report = stages::full_statics(model, options, {start.t, start.u, 0}, load,
                                           [&](const stages::StaticState& now, const stages::StaticReport& so_far) {
                                             state.t = now.fraction;
                                             state.u = now.u;
                                             state.energies.elastic = now.energy;
                                             reached(state, {so_far.newton_iterations, so_far.halvings});
                                           });
  return {.end = state.t,
          .newton_iterations = report.newton_iterations,
          .factorizations = report.factorizations,
          .rejected = report.halvings,
          .inverted_cells = report.inverted_cells,
          .elastic = state.energies.elastic,
          .balance = {}};
}

stages::DynamicOptions dynamic_options(const scene::Scene& scene) {
  const auto& time = std::get<scene::Time>(scene.analysis);
  return {.integrator = integrator_of(time), .alpha = scene.damping.alpha, .beta = scene.damping.beta, .dt = time.step};
}

FullResult run_dynamics(stages::FullModel& model, const scene::Scene& scene, const stages::DynamicState& start,
                        std::int64_t steps, const stages::LoadAt& load, FullRecorder& recorder,
                        const Reached& reached) {
  const auto options = dynamic_options(scene);
  auto first = start.t > 0 ? start : stages::start_dynamics(model, options, start, load);
  if (first.a.cols() == 0) first.a = stages::balanced_acceleration(model, options, first, load);
  const auto energy = [](const stages::DynamicState& state) { return state.energies.kinetic + state.energies.elastic; };
  double largest = energy(first);
  stages::DynamicState last = first;
  recorder.start(first);
  const auto report = stages::full_dynamics(model, options, first, steps, load,
                                            [&](const stages::DynamicState& state, const stages::DynamicReport& now) {
                                              largest = std::max(largest, energy(state));
                                              last = state;
                                              reached(state, {now.newton_iterations, now.rejected});
                                            });
  return {.end = last.t,
          .newton_iterations = report.newton_iterations,
          .factorizations = report.factorizations,
          .rejected = report.rejected,
          .inverted_cells = stages::inverted_cells(model, last.u),
          .elastic = last.energies.elastic,
          .balance = EnergyBalance{last.energies, largest, report.gained, report.lost}};
}

/// Times, energies and probes of all steps are held until the end.
void refuse_beyond_room(const config::Config& config, const scene::Scene& scene, const mesh::Mesh& mesh, double from) {
  constexpr double energies = 110, number = 17;  // bytes of text
  scene::Recording recording;
  recording.steps = std::max<std::int64_t>(step_count_from(scene, from), 0);
  recording.frames = scene::frame_count({config.full.frames, config.full.every}, recording.steps);
  recording.bytes_a_step = 8 + energies + number * static_cast<double>(scene::probe_columns(scene.probes).size());
  recording.bytes_a_frame = 24 * static_cast<double>(mesh.vertices_total);
  const double memory = free_memory_per_rank(mesh.comm);
  parallel::on_root(mesh.comm, [&] { scene::refuse_beyond_room(recording, config.output, memory); });
}

}  // namespace

void simulate(MPI_Comm comm, const config::Config& config) {
  Progress progress(comm, config.voice);
  const auto scene = read_full_scene(comm, config.full.scene);
  const auto outputs = claim_motion(comm, config, scene);
  for (const auto& text : config.warnings) progress.warn(text);
  auto mesh = progress.stage("mesh", [&] { return mesh::read(comm, config.source); });
  outputs.refuse_inputs(mesh.files);
  auto dofs = mesh::number(mesh, config.supports, config.file_supports);
  auto materials = config::region_materials(config, mesh.regions);
  for (const auto& text : warnings(config, mesh, dofs, materials)) progress.warn(text);

  const auto checksum = checksums(mesh, dofs, materials).problem;
  if (config.full.restart)
    if (const auto unchecked =
            verify_last_state(comm, *config.full.restart, "-restart " + config.full.restart->string());
        !unchecked.empty())
      progress.warn(unchecked);
  auto start = first_state(config, mesh, dofs, scene, checksum);
  refuse_beyond_room(config, scene, mesh, start.t);
  const auto times = times_from(scene, start.t);
  const auto steps = static_cast<std::int64_t>(times.size()) - 1;
  const auto frames = scene::frame_schedule({config.full.frames, config.full.every}, steps);

  const auto problem = progress.stage(
      "assemble", [&] { return stages::assemble(std::move(mesh), std::move(dofs), std::move(materials)); });
  const auto load = scene_loads(scene, problem);
  auto model = stages::full_model(problem, linear_solver(config, problem.dofs));
  if (start.t == 0 && scene.initial && std::holds_alternative<scene::StaticStart>(*scene.initial))
    start = progress.stage("start", [&] { return static_start(model, load); });
  const Balanced balanced = [&](const stages::DynamicState& state) {
    return stages::balanced_acceleration(model, dynamic_options(scene), state, load);
  };
  FullRecorder recorder(config, scene, problem, plan(scene, times, frames), frames, balanced);
  stages::DynamicState last = start;
  const Reached reached = [&](const stages::DynamicState& state, const Effort& so_far) {
    recorder.step(state, so_far);
    progress.update("", (state.t - start.t) / (times.back() - start.t));
    last = state;
  };
  auto result = progress.stage("run", [&] {
    return std::holds_alternative<scene::Time>(scene.analysis)
               ? run_dynamics(model, scene, start, steps, load, recorder, reached)
               : run_statics(model, scene, start, load, recorder, reached);
  });
  result.start = start.t;
  result.steps = steps;
  result.seconds = progress.seconds().back().seconds;
  progress.stage("write", [&] { recorder.finish(last, checksum); });
  auto summary = written_summary(comm, config, [&] { return full_summary(config, scene, problem, result, progress); });
  outputs.publish([&] {
    if (summary) summary->publish();
    recorder.publish();
  });
  progress.line(result_lines(result, problem.dofs.total, config.voice) + "\n" + peak_memory_line(comm) + "\n" +
                outputs.replaced() + "wrote " + config.output.string());
}

}  // namespace ritz::app
