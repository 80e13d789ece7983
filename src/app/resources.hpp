// What the machine gives and what the run took.
#pragma once
#include <mpi.h>

#include <string>

namespace ritz::app {

/// Bytes of memory that are free on this rank's machine, shared among the ranks on it. *Collective*.
double free_memory_per_rank(MPI_Comm comm);

/// The most memory that the processes of a run have held so far, bytes.
struct Memory {
  double largest_rank = 0;
  double all_ranks = 0;  ///< the sum over the ranks
};

/// *Collective*.
Memory peak_memory(MPI_Comm comm);

/// "peak memory 1.2 GB over 2 ranks". *Collective*.
std::string peak_memory_line(MPI_Comm comm);

}  // namespace ritz::app
