// The results of a run of ritz-full, printed and in its summary.
#pragma once
#include "ritz/app/summary.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// The energy of a motion, J.
struct EnergyBalance {
  stages::Energies last;
  double largest = 0;           ///< largest sum of kinetic and elastic energy
  double gained = 0, lost = 0;  ///< as in stages::DynamicReport
};

struct FullResult {
  double start = 0, end = 0;  ///< time, s, or load fraction of the first and the last state
  std::int64_t steps = 0;
  double seconds = 0;  ///< time that the steps took
  std::int64_t newton_iterations = 0;
  std::int64_t factorizations = 0;
  std::int64_t rejected = 0;  ///< steps, or load increments, that were halved
  std::int64_t inverted_cells = 0;
  double elastic = 0;                    ///< elastic energy at the end, J
  std::optional<EnergyBalance> balance;  ///< for a motion
};

/// The results as text to be printed.
std::string result_lines(const FullResult& result, std::int64_t degrees_of_freedom);

/// *Collective*. The results as members of the summary.
files::Json::Object full_summary(const config::Config& config, const scene::Scene& scene,
                                 const stages::Problem& problem, const FullResult& result, const Progress& progress);

}  // namespace ritz::app
