#include "ritz/app/full.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/app/checksums.hpp"
#include "ritz/app/full_recorder.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/app/warnings.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/base/error.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene/frames.hpp"

namespace ritz::app {
namespace {

stages::FullIntegrator integrator_of(const scene::Time& time) {
  switch (time.integrator.value_or(scene::Integrator::avf)) {
    case scene::Integrator::avf: return stages::FullIntegrator::avf;
    case scene::Integrator::newmark: return stages::FullIntegrator::newmark;
    case scene::Integrator::implicit_euler: return stages::FullIntegrator::implicit_euler;
    default: break;
  }
  const auto name = scene::integrator_names[static_cast<std::size_t>(*time.integrator)];
  throw InputError("[time] integrator = \"" + std::string(name) +
                   "\": the full model has avf, newmark and implicit-euler");
}

/// The scene, the same on all ranks, with what the full model cannot do refused.
scene::Scene read_scene(MPI_Comm comm, const std::filesystem::path& path) {
  scene::Scene scene;
  parallel::together(comm, [&] {
    scene = scene::read(path);
    if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) integrator_of(*time);
    if (!scene.damping.ratio.empty())
      throw InputError(path.string() + ": [damping] ratio is for modes; the full model has alpha and beta");
  });
  return scene;
}

petsc::LinearSolver linear_solver(const config::Config& config, const mesh::Dofs& dofs) {
  return choose_strategy(config, dofs).strategy == stages::Strategy::direct ? petsc::LinearSolver::direct
                                                                            : petsc::LinearSolver::iterative;
}

/// At rest, or where an earlier run stopped. Time goes on from a motion's last state; from a static one, released, it
/// starts at 0.
stages::DynamicState first_state(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                 const scene::Scene& scene, const std::string& problem_checksum) {
  const petsc::Tall zeros = petsc::Tall::Zero(dofs.owned, 1);
  if (!config.full.restart) return {0, zeros, zeros, zeros, {}};
  const LastState last = read_last_state(*config.full.restart, mesh, problem_checksum);
  const auto free = [&](const petsc::Tall& u) { return mesh::from_vertices(mesh, dofs, u); };
  const bool moves = std::holds_alternative<scene::Time>(scene.analysis);
  if (!moves && last.kind == StateKind::moving)
    throw InputError("-restart " + config.full.restart->string() +
                     ": its last state moves, and [static] cannot go on from there");
  if (moves && last.kind == StateKind::at_rest) return {0, free(last.u), zeros, zeros, {}};
  const auto& n = last.numbers;
  return {n.at("t"),
          free(last.u),
          free(last.v),
          free(last.a),
          {n.at("kinetic"), n.at("elastic"), n.at("work"), n.at("dissipated"), n.at("start")}};
}

/// Times (or load fractions) from `from` on that the scene's steps reach, `from` included.
std::vector<double> times_from(const scene::Scene& scene, double from) {
  std::vector<double> times = {from};
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) {
    const auto steps = static_cast<std::int64_t>(std::ceil((time->end - from) / time->step - 1e-9));
    for (std::int64_t n = 1; n <= steps; ++n) times.push_back(from + static_cast<double>(n) * time->step);
  } else {
    const int steps = std::get<scene::Static>(scene.analysis).steps;
    for (int n = 1; n <= steps; ++n)
      if (const double t = static_cast<double>(n) / steps; t > from * (1 + 1e-9)) times.push_back(t);
  }
  if (times.size() == 1)
    throw InputError("nothing is left to do: the state to start from, at " + stages::shown(from) +
                     ", is the scene's end or later");
  return times;
}

FullPlan plan(const scene::Scene& scene, std::vector<double> times, const std::vector<std::int64_t>& frames) {
  FullPlan plan;
  for (const auto state : frames) plan.frame_times.push_back(times[static_cast<std::size_t>(state)]);
  plan.times = std::move(times);
  plan.time_units = std::holds_alternative<scene::Time>(scene.analysis) ? "s" : "1";
  return plan;
}

std::string inside_out(std::int64_t cells) {
  return cells == 0 ? "" : "\n" + std::to_string(cells) + " cells are inside out at the end";
}

/// What takes the states, and where it is told how far the run is.
using Reached = std::function<void(const stages::DynamicState&)>;

std::string run_statics(stages::FullModel& model, const scene::Scene& scene, const stages::DynamicState& start,
                        const stages::LoadAt& load, const Reached& reached) {
  const stages::StaticOptions options{.steps = std::get<scene::Static>(scene.analysis).steps};
  stages::DynamicState state = start;
  reached(state);
  const auto report =
      stages::full_statics(model, options, {start.t, start.u, 0}, load, [&](const stages::StaticState& now) {
        state.t = now.fraction;
        state.u = now.u;
        state.energies.elastic = now.energy;
        reached(state);
      });
  return std::to_string(report.newton_iterations) + " Newton iterations, " + std::to_string(report.halvings) +
         " load increments halved" + inside_out(report.inverted_cells);
}

std::string run_dynamics(stages::FullModel& model, const scene::Scene& scene, const stages::DynamicState& start,
                         std::int64_t steps, const stages::LoadAt& load, const Reached& reached) {
  const auto& time = std::get<scene::Time>(scene.analysis);
  const stages::DynamicOptions options{
      .integrator = integrator_of(time), .alpha = scene.damping.alpha, .beta = scene.damping.beta, .dt = time.step};
  const auto first = start.t > 0 ? start : stages::start_dynamics(model, options, start, load);
  double largest = 0;
  stages::DynamicState last;
  const auto watch = [&](const stages::DynamicState& state) {
    largest = std::max(largest, state.energies.kinetic + state.energies.elastic);
    last = state;
    reached(state);
  };
  watch(first);
  const auto report = stages::full_dynamics(model, options, first, steps, load, watch);
  return std::to_string(report.newton_iterations) + " Newton iterations, " + std::to_string(report.rejected) +
         " steps rejected and halved\nenergy balance: at most " + stages::shown(report.largest_drift) +
         " J of E - E0 - W + Q, the largest energy being " + stages::shown(largest) + " J" +
         inside_out(stages::inverted_cells(model, last.u));
}

}  // namespace

void simulate(MPI_Comm comm, const config::Config& config) {
  Progress progress(comm, config.voice);
  const auto scene = read_scene(comm, config.full.scene);
  refuse_unwritable(comm, config.output);
  const auto mesh = progress.stage("mesh", [&] { return mesh::read(comm, config.source); });
  const auto dofs = mesh::number(mesh, config.supports, config.file_supports);
  const auto materials = config::region_materials(config, mesh.regions);
  for (const auto& text : warnings(mesh, materials)) progress.warn(text);

  const auto problem = checksums(mesh, dofs, materials).problem;
  const auto start = first_state(config, mesh, dofs, scene, problem);
  const auto times = times_from(scene, start.t);
  const auto steps = static_cast<std::int64_t>(times.size()) - 1;
  const auto frames = scene::frame_schedule({config.full.frames, config.full.every}, steps);

  const auto full = progress.stage("assemble", [&] { return stages::assemble(mesh, dofs, materials); });
  const auto load = scene_loads(scene, mesh, dofs, full);
  auto model = stages::full_model(mesh, dofs, full, linear_solver(config, dofs));
  FullRecorder recorder(config, scene, mesh, dofs, materials, plan(scene, times, frames), frames);
  stages::DynamicState last = start;
  const auto reached = [&](const stages::DynamicState& state) {
    recorder.record(state);
    progress.update("", (state.t - start.t) / (times.back() - start.t));
    last = state;
  };
  const auto summary = progress.stage("run", [&] {
    return std::holds_alternative<scene::Time>(scene.analysis) ? run_dynamics(model, scene, start, steps, load, reached)
                                                               : run_statics(model, scene, start, load, reached);
  });
  progress.stage("write", [&] { recorder.commit(last, problem); });
  progress.line(std::to_string(steps) + " steps of " + std::to_string(dofs.total) + " degrees of freedom: " + summary +
                "\n" + peak_memory_line(comm) + "\nwrote " + config.output.string());
}

}  // namespace ritz::app
