#include "ritz/app/summary.hpp"

#include <algorithm>

#include "ritz/app/full_start.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::app {
namespace {

using files::Json;

double largest_drift(const EnergyBalance& balance) { return std::max(balance.gained, balance.lost); }

Json energy_summary(const std::optional<EnergyBalance>& balance) {
  if (!balance) return nullptr;
  const auto& e = balance->last;
  return Json::Object{{"start", e.start},
                      {"kinetic", e.kinetic},
                      {"elastic", e.elastic},
                      {"largest", balance->largest},
                      {"work", e.work},
                      {"dissipated", e.dissipated},
                      {"gained", balance->gained},
                      {"lost", balance->lost},
                      {"largest_drift", largest_drift(*balance)}};
}

}  // namespace

std::string result_lines(const FullResult& result, std::int64_t degrees_of_freedom) {
  std::string text = std::to_string(result.steps) + " steps of " + std::to_string(degrees_of_freedom) +
                     " degrees of freedom: " + std::to_string(result.newton_iterations) + " Newton iterations, " +
                     std::to_string(result.rejected);
  if (const auto& balance = result.balance)
    text += " steps rejected and halved\nenergy balance: at most " + shown(largest_drift(*balance), 3) +
            " J of E - E0 - W + Q, the largest energy being " + shown(balance->largest, 3) + " J";
  else text += " load increments halved";
  if (const auto cells = result.inverted_cells; cells > 0)
    text += "\n" + counted(cells, "cell is", "cells are") + " inside out at the end";
  return text;
}

files::Json::Object full_summary(const config::Config& config, const scene::Scene& scene,
                                 const stages::Problem& problem, const FullResult& result, const Progress& progress) {
  auto summary = summary_head(problem.mesh.comm, "ritz-full", config, progress);
  const Json integrator = result.balance ? Json(integrator_name(scene)) : nullptr;
  const Json::Object run = {{"problem", problem_summary(problem)},
                            {"analysis", result.balance ? "dynamics" : "statics"},
                            {"integrator", integrator},
                            {"start", result.start},
                            {"end", result.end},
                            {"steps", result.steps},
                            {"newton_iterations", result.newton_iterations},
                            {"rejected_steps", result.rejected},
                            {"factorizations", result.factorizations},
                            {"inverted_cells", result.inverted_cells},
                            {"seconds", result.seconds},
                            {"energy", energy_summary(result.balance)},
                            {"elastic_energy", result.elastic}};
  summary.insert(summary.end(), run.begin(), run.end());
  return summary;
}

}  // namespace ritz::app
