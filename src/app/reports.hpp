// The files of solvers' reports and of the log, which PETSc writes by itself.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// Throws InputError on all ranks when a report's file has no folder, is a link or no regular file, or would take the
/// place of a file that the run reads, of the output, or of another report. *Collective*.
void refuse_reports(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
