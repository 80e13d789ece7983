// ritz-reduce: the pipeline, which reads as a table of contents of the method.
#pragma once
#include <mpi.h>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// *Collective*. Computes a model from a mesh and writes it. Throws InputError or NumericalError on all ranks.
void reduce(MPI_Comm comm, const config::Config& config);

}  // namespace ritz::app
