// The summary of a run: what is printed, as numbers in a JSON file. See docs/summary.md.
#pragma once
#include <optional>

#include "ritz/app/pending_file.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/files/json.hpp"
#include "ritz/stages/assemble.hpp"

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

}  // namespace ritz::app
