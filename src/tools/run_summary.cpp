#include "run_summary.hpp"

#include <sys/resource.h>

#include "ritz/base/version.hpp"
#include "run_text.hpp"

namespace ritz::tools {
namespace {

using files::Json;

/// The most that this process held, bytes.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

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
  const double memory = peak_memory();
  return Json::Object{{"format", "ritz-summary"},
                      {"version", 1},
                      {"program", "ritz-run"},
                      {"program_version", version},
                      {"ranks", 1},
                      {"output", run.options.output.string()},
                      {"stages", Json::Array{}},
                      {"memory", Json::Object{{"largest_rank", memory}, {"all_ranks", memory}}},
                      {"warnings", files::json_list(run.warnings)},
                      {"model", run.options.model.string()},
                      {"analysis", timed ? "dynamics" : "statics"},
                      {"integrator", timed ? Json(integrator_name(run.scene, run.body)) : Json(nullptr)},
                      {"precision", run.options.precision == world::Precision::single ? "single" : "double"},
                      {"coordinates", world::reduced_size(run.body)},
                      {"steps", run.result.steps},
                      {"newton_iterations", run.result.iterations},
                      {"rejected_steps", run.result.rejected},
                      {"seconds", run.result.seconds},
                      {"frames", run.frames},
                      {"inverted_cells", run.inverted_cells},
                      {"energy", energy(run.result.energy)}};
}

}  // namespace ritz::tools
