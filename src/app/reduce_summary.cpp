#include "ritz/app/reduce_summary.hpp"

#include <algorithm>

#include "ritz/app/frequencies.hpp"

namespace ritz::app {
namespace {

using Eigen::Index;
using files::Json, files::json_list;

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json::Array rows;
  for (Index i = 0; i < matrix.rows(); ++i) rows.emplace_back(json_list(matrix.row(i)));
  return rows;
}

Json inertia_summary(const model::Inertia& inertia) {
  return Json::Object{{"centre_of_mass", json_list(inertia.centre_of_mass())}, {"tensor", rows_of(inertia.tensor())}};
}

Json certificate_summary(const model::Certificate& certificate) {
  return Json::Object{{"kind", word(certificate.kind)},
                      {"shift", certificate.shift},
                      {"shift_hz", frequency(certificate.shift)},
                      {"counted", certificate.counted},
                      {"found", certificate.found}};
}

Json modes_summary(const stages::ModesResult& result, const model::Inertia& inertia) {
  const model::Modes& modes = result.modes;
  const auto rigid = std::ranges::count(modes.kinds, model::ModeKind::rigid);
  Json::Array kinds, frequencies;
  for (const auto kind : modes.kinds) kinds.emplace_back(word(kind));
  for (const double eigenvalue : modes.eigenvalues) frequencies.emplace_back(frequency(eigenvalue));
  const Eigen::MatrixXd masses = inertia.effective_masses();
  const bool moving = masses.rows() == modes.eigenvalues.size();
  return Json::Object{{"rigid", rigid},
                      {"flexible", modes.eigenvalues.size() - rigid},
                      {"solver", result.strategy == stages::Strategy::direct ? "direct" : "iterative"},
                      {"iterations", result.iterations},
                      {"orthonormality", modes.orthonormality},
                      {"certificate", certificate_summary(modes.certificate)},
                      {"kind", std::move(kinds)},
                      {"frequency_hz", std::move(frequencies)},
                      {"eigenvalue", json_list(modes.eigenvalues)},
                      {"residual", json_list(modes.residuals)},
                      {"effective_mass", moving ? rows_of(masses) : nullptr},
                      {"participation", moving ? rows_of(inertia.participation_factors()) : nullptr}};
}

Json basis_summary(const ReducedBasis& basis, const model::Inertia& inertia) {
  if (!basis.reduction) return nullptr;
  const auto& sigma = basis.reduction->singular_values;
  const Index columns = basis.reduction->stiffness.size();
  return Json::Object{{"columns", columns},
                      {"singular_values_kept", json_list(sigma.head(columns))},
                      {"singular_values_left_out", json_list(sigma.tail(sigma.size() - columns))},
                      {"discarded", basis.reduction->discarded},
                      {"orthonormality", basis.figures.orthonormality},
                      {"effective_mass", json_list(Eigen::Vector3d(inertia.effective_masses().colwise().sum()))}};
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
  return Json::Object{
      {"coordinates", value.r},
      {"quadratic", value.quadratic.size()},
      {"cubic", value.cubic.size()},
      {"quartic", value.quartic.size()},
      {"witness", Json::Object{{"force", errors.force}, {"energy", errors.energy}, {"stiffness", errors.stiffness}}}};
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
                                  const Results& results, const model::Inertia& of_modes, const Progress& progress) {
  auto summary = beginning(config, problem, earlier, progress);
  summary.emplace_back("inertia", inertia_summary(results.inertia));
  summary.emplace_back("modes", modes_summary(results.modes, of_modes));
  summary.emplace_back("basis", basis_summary(results.basis, results.inertia));
  summary.emplace_back("derivatives", derivatives_summary(results.basis.figures));
  summary.emplace_back("accuracy", accuracy_summary(results.basis.figures.accuracy));
  summary.emplace_back("polynomial", polynomial_summary(results.polynomial));
  summary.emplace_back("plan", nullptr);
  return summary;
}

files::Json::Object plan_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                 const Plan& plan, const Progress& progress) {
  auto summary = beginning(config, problem, earlier, progress);
  for (const char* absent : {"inertia", "modes", "basis", "derivatives", "accuracy", "polynomial"})
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
