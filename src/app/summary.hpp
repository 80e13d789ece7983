// The summaries of ritz-reduce and ritz-full: what is printed, as numbers in a JSON file. See docs/summary.md.
#pragma once
#include <functional>
#include <optional>

#include "ritz/app/earlier.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/files/json.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// *Collective*. The members with which every summary begins. `program` is the name of the program.
files::Json::Object summary_head(MPI_Comm comm, const char* program, const config::Config& config,
                                 const Progress& progress);

/// *Collective*. The sizes of the mesh and of its equations.
files::Json problem_summary(const stages::Problem& problem);

/// *Collective*. Writes the file of -summary, if that is given, and flushes it to the disk; the caller publishes it.
/// `members` is called on all ranks and returns the contents.
std::optional<PendingFile> written_summary(MPI_Comm comm, const config::Config& config,
                                           const std::function<files::Json::Object()>& members);

/// *Collective*. Of a run that wrote a model.
files::Json::Object model_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                  const Results& results, const Progress& progress);

/// *Collective*. Of a run that printed a plan.
files::Json::Object plan_summary(const config::Config& config, const stages::Problem& problem, const Earlier& earlier,
                                 const Plan& plan, const Progress& progress);

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
std::string result_lines(const FullResult& result, std::int64_t degrees_of_freedom, Voice voice);

/// *Collective*. The results as members of the summary.
files::Json::Object full_summary(const config::Config& config, const scene::Scene& scene,
                                 const stages::Problem& problem, const FullResult& result, const Progress& progress);

}  // namespace ritz::app
