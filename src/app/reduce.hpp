// ritz-reduce: the method's table of contents.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// From a mesh to a model file. Throws InputError or NumericalError, on all ranks alike. *Collective*.
void reduce(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
