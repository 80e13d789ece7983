// Whether the files that a run is to write can be made, before it begins.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// Throws InputError on all ranks when a file cannot be made where -output or -timing says, or would take the place of
/// one that the run reads or writes besides. -reuse and -restart may name the file that the run replaces. *Collective*.
void refuse_outputs(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
