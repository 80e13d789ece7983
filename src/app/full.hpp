// ritz-full: the unreduced model under a scene, to which reduced ones are compared.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// From a mesh and a scene to a motion file. Throws InputError or NumericalError, on all ranks alike; then no file is
/// left behind or changed. *Collective*.
void simulate(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
