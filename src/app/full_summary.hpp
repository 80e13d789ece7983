// What a run of ritz-full came to: printed, and in its summary.
#pragma once
#include "ritz/app/summary.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// The energy of a motion, J.
struct EnergyBalance {
  stages::Energies last;
  double largest = 0;           ///< kinetic and elastic together
  double gained = 0, lost = 0;  ///< as stages::DynamicReport has them
};

struct FullResult {
  double start = 0, end = 0;  ///< time, s, or load fraction of the first and the last state
  std::int64_t steps = 0;
  double seconds = 0;  ///< that they took
  std::int64_t newton_iterations = 0;
  std::int64_t factorizations = 0;
  std::int64_t rejected = 0;  ///< steps, or increments of the load, that were halved
  std::int64_t inverted_cells = 0;
  double elastic = 0;                    ///< energy at the end, J
  std::optional<EnergyBalance> balance;  ///< of a motion
};

/// For people.
std::string result_lines(const FullResult& result, std::int64_t degrees_of_freedom);

/// *Collective*.
files::Json::Object full_summary(const config::Config& config, const scene::Scene& scene,
                                 const stages::Problem& problem, const FullResult& result, const Progress& progress);

}  // namespace ritz::app
