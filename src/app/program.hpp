// The programs ritz-reduce and ritz-full: what each does, their start and end, and the exit code.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// *Collective*. Computes a model from a mesh and writes it. Throws InputError or NumericalError on all ranks.
void reduce(MPI_Comm comm, const config::Config& config);

/// *Collective*. Computes a motion from a mesh and a scene, and writes it. Throws InputError or NumericalError on all
/// ranks; then no file is left behind or changed.
void simulate(MPI_Comm comm, const config::Config& config);

/// Runs `work`. On an error prints one sentence on stderr, once, and returns the exit code, the same on all ranks. If
/// only some ranks failed (by an error that no collective call reported), they end the others within seconds.
int guarded(MPI_Comm comm, const std::string& program, const std::function<void()>& work);

/// A whole program: starts MPI and PETSc, prints help if asked, or else reads the options and runs `work`; returns the
/// exit code.
int run_program(int argc, char** argv, config::Program program,
                const std::function<void(MPI_Comm, const config::Config&)>& work);

}  // namespace ritz::app
