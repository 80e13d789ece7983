// The memory of the machine and of the run.
#pragma once
#include <mpi.h>

#include <string>

namespace ritz::app {

/// *Collective*. Free memory of this rank's machine divided by the number of ranks on it, bytes.
double free_memory_per_rank(MPI_Comm comm);

/// The peak memory of the processes of a run so far, bytes.
struct Memory {
  double largest_rank = 0;
  double all_ranks = 0;  ///< sum over the ranks
};

/// *Collective*. Computes the peak memory.
Memory peak_memory(MPI_Comm comm);

/// *Collective*. "peak memory 1.2 GB over 2 ranks".
std::string peak_memory_line(MPI_Comm comm);

}  // namespace ritz::app
