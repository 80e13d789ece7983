#include "ritz/app/static_path.hpp"

#include <algorithm>

#include "ritz/app/full_start.hpp"
#include "ritz/app/scene_loads.hpp"
#include "ritz/base/error.hpp"

namespace ritz::app {
namespace {

constexpr int levels = 4;

/// The loads of a scene when they are largest. Tables are straight between their points: one of these it is.
algebra::Tall largest_load(const scene::Scene& scene, const stages::LoadAt& load, MPI_Comm comm) {
  if (std::holds_alternative<scene::Static>(scene.analysis)) return load(1);
  const double end = std::get<scene::Time>(scene.analysis).end;
  std::vector<double> times = {0, end};
  const auto note = [&](const scene::Table& table) {
    for (const auto& [t, factor] : table.points)
      if (t > 0 && t < end) times.push_back(t);
  };
  for (const auto& one : scene.loads)
    if (one.table) note(*one.table);
  if (scene.shake) note(scene.shake->table);
  algebra::Tall largest = load(0);
  for (const double t : times)
    if (auto now = load(t); algebra::column_norms(comm, now)[0] > algebra::column_norms(comm, largest)[0])
      largest = std::move(now);
  return largest;
}

}  // namespace

std::optional<stages::StaticPath> static_path(const config::Config& config, const std::optional<scene::Scene>& scene,
                                              const stages::Problem& problem, Progress& progress) {
  if (!scene) return std::nullopt;
  const mesh::Dofs& dofs = problem.dofs;
  return progress.stage("full statics", [&] {
    const auto most = largest_load(*scene, scene_loads(*scene, problem), dofs.comm);
    if (algebra::column_norms(dofs.comm, most)[0] == 0)
      throw InputError("option -accuracy_scene " + config.accuracy->scene.string() +
                       ": its loads do not push the body; give it a [[load]] or gravity");
    auto model = stages::full_model(problem, linear_solver(config, dofs));
    stages::StaticPath path{algebra::Tall(dofs.owned, levels), algebra::Tall(dofs.owned, levels)};
    int level = 0;
    stages::full_statics(
        model, {.steps = levels}, {0, algebra::Tall::Zero(dofs.owned, 1), 0},
        [&](double fraction) -> algebra::Tall { return fraction * most; },
        [&](const stages::StaticState& state, const stages::StaticReport&) {
          path.loads.col(level) = state.fraction * most;
          path.truth.col(level++) = state.u;
          progress.update("", state.fraction);
        });
    return std::optional(std::move(path));
  });
}

}  // namespace ritz::app
