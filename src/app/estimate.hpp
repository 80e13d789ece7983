// What the stages of a run would need, before they run: their work, counted, over the measured speed of the machine.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ritz/app/earlier.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// How fast this machine is, and what there is to do on this rank.
struct Workload {
  const config::Config& config;
  const stages::Problem& problem;
  const stages::ModesOptions& modes;
  double rate;    ///< floating point operations a second of one rank
  double memory;  ///< bytes a second that one rank reads
  double ranks;
  double speed;  ///< of all ranks together, over that of one
  double dofs;   ///< N, free degrees of freedom of all ranks
  double rows;   ///< N over the ranks
  double held;   ///< bytes that this rank holds before the modes
};

struct Estimate {
  std::string stage;
  double seconds = 0;
  double memory = 0;  ///< bytes that this rank holds at the most while the stage runs
  std::string how;
};

/// The modes, what solves with K after them where derivatives need it, and what a Newton step of the full model takes.
struct ModesEstimate {
  Estimate stage;
  double inverse_memory = 0;   ///< bytes of this rank
  double inverse_seconds = 0;  ///< a column of a block that is solved
  double newton_memory = 0;    ///< bytes of this rank
  double newton_seconds = 0;   ///< a linear solve with a new matrix
};

/// *Collective*.
Workload workload(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& modes);

/// *Collective*.
ModesEstimate estimate_modes(const Workload& work);

/// The stages that the options ask for, in the order in which they run: full statics, modes, basis, polynomial,
/// witness; without what an earlier model has done. Throws InputError for snapshots that do not fit the mesh.
/// *Collective*.
std::vector<Estimate> estimate_stages(const Workload& work, const std::optional<FinishedBasis>& earlier);

/// "1.5 s".
std::string shown_seconds(double seconds);

}  // namespace ritz::app
