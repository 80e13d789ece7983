// The summary of a run, as docs/summary.md describes it: what is printed, as numbers in a file of JSON.
#pragma once
#include <optional>

#include "ritz/app/pending_file.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/files/json.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::app {

/// What every summary begins with. `program`: its name. *Collective*.
files::Json::Object summary_head(MPI_Comm comm, const char* program, const config::Config& config,
                                 const Progress& progress);

/// Sizes of the mesh and of its equations. *Collective*.
files::Json problem_summary(const stages::Problem& problem);

/// The summary's file where -summary names one: written and on the disk, without its name yet. `members` makes its
/// contents, on all ranks. *Collective*.
std::optional<PendingFile> written_summary(MPI_Comm comm, const config::Config& config,
                                           const std::function<files::Json::Object()>& members);

}  // namespace ritz::app
