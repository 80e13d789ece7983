#include "run_summary.hpp"

#include <utility>

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

Json::Object members(const Summarised& run, const BodyResult& body) {
  const bool timed = std::holds_alternative<scene::Time>(run.scene.analysis);
  return {{"model", body.body.model_file.string()},
          {"analysis", timed ? "dynamics" : "statics"},
          {"integrator", timed ? Json(body.result.integrator) : Json(nullptr)},
          {"precision", run.options.precision == world::Precision::float32 ? "single" : "double"},
          {"coordinates", world::reduced_size(*body.body.model)},
          {"steps", body.result.steps},
          {"newton_iterations", body.result.iterations},
          {"rejected_steps", body.result.rejected},
          {"seconds", body.result.seconds},
          {"frames", run.frames},
          {"inverted_cells", body.inverted_cells},
          {"energy", energy(body.result.energy)}};
}

}  // namespace

files::Json summary(const Summarised& run) {
  const double memory = files::peak_memory();
  auto all = files::summary_head({.program = "ritz-run",
                                  .ranks = 1,
                                  .output = run.options.output.string(),
                                  .stages = {},
                                  .largest_rank = memory,
                                  .all_ranks = memory,
                                  .warnings = run.warnings});
  if (run.scene.bodies.empty()) {
    const auto own = members(run, run.bodies.front());
    all.insert(all.end(), own.begin(), own.end());
    return all;
  }
  Json::Array bodies;
  for (const auto& body : run.bodies) {
    Json::Object named{{"name", body.body.name}, {"output", body.output.string()}};
    const auto own = members(run, body);
    named.insert(named.end(), own.begin(), own.end());
    bodies.emplace_back(std::move(named));
  }
  all.emplace_back("bodies", std::move(bodies));
  return all;
}

}  // namespace ritz::tools
