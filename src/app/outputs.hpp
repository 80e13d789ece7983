// The names of the files that a run is to write, taken before it begins.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {

/// A files::Claim, held by rank 0 until the run ends.
class Outputs {
 public:
  /// Throws InputError on all ranks as files::Claim does. *Collective*.
  Outputs(MPI_Comm comm, const files::Plan& plan);

  /// For files that only reading the mesh shows (rank 0's): throws InputError when an output would take the place of
  /// one. *Collective*.
  void refuse_inputs(const std::vector<std::filesystem::path>& read) const;

  /// When all is written: `give_names` publishes the files, and no interruption comes between. Throws InputError when
  /// another run has written one meanwhile. *Collective*.
  void publish(const std::function<void()>& give_names) const;

 private:
  MPI_Comm comm_;
  std::optional<files::Claim> claim_;
};

/// What ritz-reduce writes: the model, its link, its table of frequencies, and what -export and -summary ask for;
/// -reuse may name the model that the run replaces. *Collective*.
Outputs claim_model(MPI_Comm comm, const config::Config& config);

/// What a run without a model writes (-plan): the summary and the reports of solvers, if any. The output keeps its
/// name. *Collective*.
std::optional<Outputs> claim_reports(MPI_Comm comm, const config::Config& config);

/// What ritz-full writes under `scene`; -restart may name the file that the run replaces. *Collective*.
Outputs claim_motion(MPI_Comm comm, const config::Config& config, const scene::Scene& scene);

}  // namespace ritz::app
