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

std::string result_lines(const FullResult& result, std::int64_t degrees_of_freedom, Voice voice) {
  const std::string step = result.balance ? "step" : "load step";
  std::string text =
      counted(result.steps, step, step + "s") + " of " + std::to_string(degrees_of_freedom) + " degrees of freedom";
  if (result.rejected > 0)
    text += "; " + counted(result.rejected, "attempt", "attempts") + " did not converge and went on in halves";
  if (voice == Voice::verbose)
    text += "\n  " + std::to_string(result.newton_iterations) + " Newton iterations, " +
            counted(result.factorizations, "factorization", "factorizations");
  if (const auto& balance = result.balance)
    text += "\nenergy balance: at most " + shown(largest_drift(*balance), 3) +
            " J came from nowhere or were lost (energy - energy at the start - work + damping), of " +
            shown(balance->largest, 3) + " J in the body";
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
