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

/// The factor of a solid of N degrees of freedom, bytes over all ranks, without an analysis: fill grows like N^1.41.
double rough_factor_bytes(double N);

/// *Collective*. The options of the modes, with a strategy: the one of -solver, or (auto) the direct one unless the
/// factors that are held at the same time are estimated not to fit into the free memory.
stages::ModesOptions choose_strategy(const config::Config& config, const mesh::Dofs& dofs);

/// The estimated rest of the run.
struct Plan {
  std::vector<Estimate> stages;  ///< the last one writes the model; memory of the rank that needs most
  double seconds = 0;            ///< of the whole run, including what was done for the plan
  Memory memory;                 ///< peak
};

/// *Collective*. The stages that the options ask for and that an earlier model does not provide.
Plan make_plan(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& options,
               const Earlier& earlier, const Progress& progress);

void print_plan(MPI_Comm comm, const Plan& plan, const Progress& progress);

}  // namespace ritz::app
