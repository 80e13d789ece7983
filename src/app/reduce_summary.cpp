#include "ritz/app/summary.hpp"

#include "ritz/app/static_loads.hpp"
#include "ritz/format/summaries.hpp"

namespace ritz::app {
namespace {

using files::Json, files::json_list;

/// What ritz-reduce knows of its modes: also who found them.
Json modes_summary(const Results& results) {
  const stages::ModesResult& result = results.modes;
  const model::Inertia& inertia = results.of_modes;
  const bool at_hand = inertia.effective_masses().rows() == result.modes.eigenvalues.size();
  auto members = format::summary(result.modes, at_hand ? &inertia : nullptr);
  members.emplace_back("solver", result.strategy == stages::Strategy::direct ? "direct" : "iterative");
  members.emplace_back("iterations", result.iterations);
  const auto& errors = results.mesh_errors;
  members.emplace_back("mesh_error", errors.size() > 0 ? Json(json_list(errors)) : nullptr);
  return members;
}

Json basis_summary(const ReducedBasis& basis, const model::Inertia& inertia) {
  if (!basis.reduction) return nullptr;
  auto members = format::summary(*basis.reduction);
  members.emplace_back("orthonormality", basis.figures.orthonormality);
  members.emplace_back("effective_mass", json_list(Eigen::Vector3d(inertia.effective_masses().colwise().sum())));
  return members;
}

Json derivatives_summary(const BasisFigures& figures) {
  if (!figures.derivatives) return nullptr;
  const auto& counts = *figures.derivatives;
  return Json::Object{
      {"pairs", counts.pairs},           {"solved", counts.solved},     {"skipped", counts.pairs - counts.solved},
      {"iterations", counts.iterations}, {"residual", counts.residual}, {"taylor_slope", figures.taylor_slope}};
}

Json accuracy_summary(const std::optional<Accuracy>& accuracy) {
  if (!accuracy) return nullptr;
  return Json::Object{{"target", accuracy->target},
                      {"error", accuracy->reached.error},
                      {"modes", accuracy->reached.modes},
                      {"columns", accuracy->reached.columns}};
}

Json polynomial_summary(const std::optional<ReducedPolynomial>& polynomial) {
  if (!polynomial) return nullptr;
  const auto& [value, errors] = *polynomial;
  auto members = format::summary(value);
  members.emplace_back(
      "witness", Json::Object{{"force", errors.force}, {"energy", errors.energy}, {"stiffness", errors.stiffness}});
  return members;
}

const char* reused(const Earlier& earlier) {
  if (earlier.basis) return "basis";
  return earlier.modes.cols() > 0 ? "modes" : "nothing";
}

files::Json::Object beginning(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                              const Progress& progress) {
  auto summary = summary_head(problem.mesh.comm, "ritz-reduce", config, progress);
  summary.emplace_back("problem", problem_summary(problem));
  summary.emplace_back("reused", reused(earlier));
  return summary;
}

}  // namespace

files::Json::Object model_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                  const Results& results, const Progress& progress) {
  auto summary = beginning(config, problem, earlier, progress);
  summary.emplace_back("inertia", format::summary(results.inertia));
  summary.emplace_back("modes", modes_summary(results));
  summary.emplace_back("basis", basis_summary(results.basis, results.inertia));
  summary.emplace_back("derivatives", derivatives_summary(results.basis.figures));
  summary.emplace_back("accuracy", accuracy_summary(results.basis.figures.accuracy));
  summary.emplace_back("polynomial", polynomial_summary(results.forces.polynomial));
  const auto& cubature = results.forces.cubature;
  summary.emplace_back("cubature", cubature ? Json(format::summary(*cubature)) : Json(nullptr));
  summary.emplace_back("static_errors", static_error_summary(results.basis.figures.static_errors));
  summary.emplace_back("plan", nullptr);
  return summary;
}

files::Json::Object plan_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                 const Plan& plan, const Progress& progress) {
  auto summary = beginning(config, problem, earlier, progress);
  for (const char* absent :
       {"inertia", "modes", "basis", "derivatives", "accuracy", "polynomial", "cubature", "static_errors"})
    summary.emplace_back(absent, nullptr);
  Json::Array stages;
  for (const auto& [stage, seconds, memory, how] : plan.stages)
    stages.emplace_back(Json::Object{{"stage", stage}, {"seconds", seconds}, {"memory", memory}, {"how", how}});
  summary.emplace_back("plan", Json::Object{{"stages", std::move(stages)},
                                            {"seconds", plan.seconds},
                                            {"memory", Json::Object{{"largest_rank", plan.memory.largest_rank},
                                                                    {"all_ranks", plan.memory.all_ranks}}}});
  return summary;
}

}  // namespace ritz::app
