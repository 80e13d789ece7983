#include "ritz/app/full_start.hpp"

#include <cmath>

#include "ritz/app/full_file.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::app {
namespace {

std::string name_of(scene::Integrator integrator) {
  return std::string(scene::integrator_names[static_cast<std::size_t>(integrator)]);
}

}  // namespace

stages::FullIntegrator integrator_of(const scene::Time& time) {
  switch (time.integrator.value_or(scene::Integrator::avf)) {
    case scene::Integrator::avf: return stages::FullIntegrator::avf;
    case scene::Integrator::newmark: return stages::FullIntegrator::newmark;
    case scene::Integrator::implicit_euler: return stages::FullIntegrator::implicit_euler;
    default: break;
  }
  throw InputError("[time] integrator = \"" + name_of(*time.integrator) +
                   "\": the full model has avf, newmark and implicit-euler");
}

std::string integrator_name(const scene::Scene& scene) {
  const auto* time = std::get_if<scene::Time>(&scene.analysis);
  return time ? name_of(time->integrator.value_or(scene::Integrator::avf)) : "none";
}

algebra::LinearSolver linear_solver(const config::Config& config, const mesh::Dofs& dofs) {
  return choose_strategy(config, dofs).strategy == stages::Strategy::direct ? algebra::LinearSolver::direct
                                                                            : algebra::LinearSolver::iterative;
}

scene::Scene read_scene(MPI_Comm comm, const std::filesystem::path& path) {
  scene::Scene scene;
  parallel::together(comm, [&] {
    scene = scene::read(path);
    if (scene.bodies.size() > 1)
      throw InputError(path.string() + ": the scene has " + std::to_string(scene.bodies.size()) +
                       " bodies, and the full model is of one: give a scene of one [[body]], or ritz-run");
  });
  return scene;
}

scene::Scene read_full_scene(MPI_Comm comm, const std::filesystem::path& path) {
  auto scene = read_scene(comm, path);
  parallel::together(comm, [&] {
    if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) integrator_of(*time);
    if (!scene.damping.ratio.empty())
      throw InputError(path.string() + ": [damping] ratio is for modes; the full model has alpha and beta");
  });
  return scene;
}

stages::DynamicState first_state(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                 const scene::Scene& scene, const std::string& problem_checksum) {
  const algebra::Tall zeros = algebra::Tall::Zero(dofs.owned, 1);
  if (!config.full.restart) return {0, zeros, zeros, zeros, {}};
  const LastState last = read_last_state(*config.full.restart, mesh, problem_checksum);
  const auto free = [&](const algebra::Tall& u) { return mesh::from_vertices(mesh, dofs, u); };
  const bool moves = std::holds_alternative<scene::Time>(scene.analysis);
  if (!moves && last.kind == StateKind::moving)
    throw InputError("-restart " + config.full.restart->string() +
                     ": its last state moves, and [static] cannot go on from there");
  if (moves && last.kind == StateKind::at_rest) return {0, free(last.u), zeros, zeros, {}};
  const auto& n = last.numbers;
  return {n.at("t"),
          free(last.u),
          free(last.v),
          last.integrator == integrator_name(scene) ? free(last.a) : algebra::Tall(dofs.owned, 0),
          {n.at("kinetic"), n.at("elastic"), n.at("work"), n.at("dissipated"), n.at("start")}};
}

std::int64_t step_count_from(const scene::Scene& scene, double from) {
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis))
    return static_cast<std::int64_t>(std::ceil((time->end - from) / time->step - 1e-9));
  return std::get<scene::Static>(scene.analysis).steps;
}

std::vector<double> times_from(const scene::Scene& scene, double from) {
  std::vector<double> times = {from};
  if (const auto* time = std::get_if<scene::Time>(&scene.analysis)) {
    const auto steps = step_count_from(scene, from);
    for (std::int64_t n = 1; n <= steps; ++n) times.push_back(from + static_cast<double>(n) * time->step);
  } else {
    const int steps = std::get<scene::Static>(scene.analysis).steps;
    for (int n = 1; n <= steps; ++n)
      if (const double t = static_cast<double>(n) / steps; t > from * (1 + 1e-9)) times.push_back(t);
  }
  if (times.size() == 1)
    throw InputError("nothing is left to do: the state to start from, at " + shown(from, 3) +
                     ", is the scene's end or later");
  return times;
}

}  // namespace ritz::app
