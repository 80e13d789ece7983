// ritz-full: the unreduced model under a scene, with which reduced models are compared.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// *Collective*. Computes a motion from a mesh and a scene, and writes it. Throws InputError or NumericalError on all
/// ranks; then no file is left behind or changed.
void simulate(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
