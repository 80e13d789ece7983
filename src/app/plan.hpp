// -plan: what a run would need.
#pragma once
#include <vector>

#include "ritz/app/earlier.hpp"
#include "ritz/app/estimate.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// The options of the modes with a strategy chosen: what -solver says, or (auto) the direct one unless the factors that
/// it holds at once are estimated not to fit into the memory that is free. *Collective*.
stages::ModesOptions choose_strategy(const config::Config& config, const mesh::Dofs& dofs);

/// What is still to run, by estimate.
struct Plan {
  std::vector<Estimate> stages;  ///< the last one writes the model; memory of the rank that holds most
  double seconds = 0;            ///< of the whole run, what was done for the plan included
  Memory memory;                 ///< at the most
};

/// The stages that the options ask for and an earlier model has not done. *Collective*.
Plan make_plan(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& options,
               const Earlier& earlier, const Progress& progress);

void print_plan(MPI_Comm comm, const Plan& plan, const Progress& progress);

}  // namespace ritz::app
