// Estimates of what the stages of a run need: their operations are counted, and divided by the measured speed of the
// machine.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ritz/app/earlier.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// The speed of this machine, and the size of the problem.
struct Workload {
  const config::Config& config;
  const stages::Problem& problem;
  const stages::ModesOptions& modes;
  double rate;    ///< floating point operations per second of one rank
  double memory;  ///< bytes per second that one rank reads
  double ranks;
  double speed;  ///< of all ranks together, relative to one
  double dofs;   ///< N, free degrees of freedom of all ranks
  double rows;   ///< N / ranks
  double held;   ///< bytes that this rank holds before the modes are computed
};

struct Estimate {
  std::string stage;
  double seconds = 0;
  double memory = 0;  ///< peak memory of this rank during the stage, bytes
  std::string how;
};

/// The cost of the modes, of solves with K after them, and of a Newton step of the full model.
struct ModesEstimate {
  Estimate stage;
  double inverse_memory = 0;   ///< bytes of this rank
  double inverse_seconds = 0;  ///< for one column of a block
  double newton_memory = 0;    ///< bytes of this rank
  double newton_seconds = 0;   ///< for one linear solve with a new matrix
};

/// *Collective*.
Workload workload(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& modes);

/// *Collective*.
ModesEstimate estimate_modes(const Workload& work);

/// *Collective*. The estimated error of each mode by the mesh.
Estimate estimate_mesh_error(const Workload& work);

/// *Collective*. The stages that the options ask for, in the order in which they run: full statics, modes, mesh error,
/// basis, polynomial, witness; without those that an earlier model provides. Throws InputError for snapshots that do
/// not fit the mesh.
std::vector<Estimate> estimate_stages(const Workload& work, const std::optional<FinishedBasis>& earlier);

/// "1.5 s".
std::string shown_seconds(double seconds);

}  // namespace ritz::app
