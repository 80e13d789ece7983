// -plan: what a run would need.
#pragma once
#include "ritz/app/earlier.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// The options of the modes with a strategy chosen: what -solver says, or (auto) the direct one unless the factors that
/// it holds at once are estimated not to fit into the memory that is free. *Collective*.
stages::ModesOptions choose_strategy(const config::Config& config, const mesh::Dofs& dofs);

/// Prints the stages that the options ask for and an earlier model has not done, the estimated peak memory a rank, and
/// the time. *Collective*.
void print_plan(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& options,
                const Earlier& earlier, const Progress& progress);

}  // namespace ritz::app
