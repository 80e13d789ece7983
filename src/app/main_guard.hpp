// How a parallel program begins and ends.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// Runs `work`; answers its errors with one sentence on stderr, printed once, and the exit code that all ranks return.
/// When only some ranks failed (a fault that no collective could carry), these end the others within seconds.
int guarded(MPI_Comm comm, const std::string& program, const std::function<void()>& work);

/// A whole program: starts MPI and PETSc, prints the help that was asked for or hands the options to `work`; returns
/// the exit code.
int run_program(int argc, char** argv, config::Program program,
                const std::function<void(MPI_Comm, const config::Config&)>& work);

}  // namespace ritz::app
