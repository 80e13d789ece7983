// What the machine gives and what the run took.
#pragma once
#include <mpi.h>

#include <string>

namespace ritz::app {

/// The most memory that this process has held so far, bytes.
double peak_memory();

/// Bytes of memory that are free on this rank's machine, shared among the ranks on it. *Collective*.
double free_memory_per_rank(MPI_Comm comm);

/// "peak memory 1.2 GB over 2 ranks". *Collective*.
std::string peak_memory_line(MPI_Comm comm);

}  // namespace ritz::app
