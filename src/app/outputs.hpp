// The output files of a run: their names are reserved before it begins, and each appears completely or not at all.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {

/// A files::PartFile of rank 0 whose name is known on all ranks.
class PendingFile {
 public:
  /// *Collective*. Creates the file. Throws on all ranks as files::PartFile does.
  PendingFile(MPI_Comm comm, const std::filesystem::path& path);

  const std::filesystem::path& part() const { return part_; }

  /// *Collective*. Writes the text of rank 0. Throws NumericalError when the disk does not take it.
  void write(const std::string& text) const;
  void finish() const;  ///< *Collective*. Flushes the file, which must be closed, to the disk.
  void publish();       ///< *Collective*. Renames it to its final name.

 private:
  MPI_Comm comm_;
  std::optional<files::PartFile> file_;  ///< on rank 0
  std::filesystem::path part_;
};

/// A files::Claim that rank 0 holds until the run ends.
class Outputs {
 public:
  /// *Collective*. Throws InputError on all ranks as files::Claim does.
  Outputs(MPI_Comm comm, const files::Plan& plan);

  /// *Collective*. For files that become known only when the mesh is read (those of rank 0): throws InputError when an
  /// output would replace one.
  void refuse_inputs(const std::vector<std::filesystem::path>& read) const;

  /// *Collective*. Call this when everything is written. `give_names` publishes the files, and interruptions wait until
  /// it is done. Throws InputError when another run has written one of them meanwhile.
  void publish(const std::function<void()>& give_names) const;

  /// As files::Claim::replaced, with a line break behind it, on rank 0; elsewhere empty.
  std::string replaced() const;

 private:
  MPI_Comm comm_;
  std::optional<files::Claim> claim_;
};

/// *Collective*. Claims what ritz-reduce writes: the model, its link, its table of frequencies, and the files of
/// -export and -summary. -reuse may name the model that the run replaces.
Outputs claim_model(MPI_Comm comm, const config::Config& config);

/// *Collective*. Claims what a run without a model writes (-plan): the summary and the reports of solvers, if any.
std::optional<Outputs> claim_reports(MPI_Comm comm, const config::Config& config);

/// *Collective*. Claims what ritz-full writes under `scene`. -restart may name the file that the run replaces.
Outputs claim_motion(MPI_Comm comm, const config::Config& config, const scene::Scene& scene);

}  // namespace ritz::app
