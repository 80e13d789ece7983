#include "run_summary.hpp"

#include "ritz/files/summary.hpp"

namespace ritz::tools {
namespace {

using files::Json;

Json energy(const std::optional<world::EnergyBalance>& balance) {
  if (!balance) return nullptr;
  return Json::Object{
      {"start", balance->start},        {"work", balance->work}, {"dissipated", balance->dissipated},
      {"gained", balance->gained},      {"lost", balance->lost}, {"largest_drift", balance->largest_drift},
      {"available", balance->available}};
}

}  // namespace

files::Json summary(const Summarised& run) {
  const bool timed = std::holds_alternative<scene::Time>(run.scene.analysis);
  const double memory = files::peak_memory();
  auto members = files::summary_head({.program = "ritz-run",
                                      .ranks = 1,
                                      .output = run.options.output.string(),
                                      .stages = {},
                                      .largest_rank = memory,
                                      .all_ranks = memory,
                                      .warnings = run.warnings});
  const Json::Object own{{"model", run.options.model.string()},
                         {"analysis", timed ? "dynamics" : "statics"},
                         {"integrator", timed ? Json(run.result.integrator) : Json(nullptr)},
                         {"precision", run.options.precision == world::Precision::single ? "single" : "double"},
                         {"coordinates", world::reduced_size(run.body)},
                         {"steps", run.result.steps},
                         {"newton_iterations", run.result.iterations},
                         {"rejected_steps", run.result.rejected},
                         {"seconds", run.result.seconds},
                         {"frames", run.frames},
                         {"inverted_cells", run.inverted_cells},
                         {"energy", energy(run.result.energy)}};
  members.insert(members.end(), own.begin(), own.end());
  return members;
}

}  // namespace ritz::tools
