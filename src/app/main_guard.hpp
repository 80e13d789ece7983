// How a parallel program ends.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>

namespace ritz::app {

/// Runs `work`; answers its errors with one sentence on stderr, printed once, and the exit code that all ranks return.
/// When only some ranks failed (a fault that no collective could carry), these end the others within seconds.
int guarded(MPI_Comm comm, const std::string& program, const std::function<void()>& work);

}  // namespace ritz::app
