// Makes a failure on one rank a failure on all ranks, before the next collective call.
#pragma once
#include <mpi.h>

#include <functional>

namespace ritz::parallel {

/// *Collective*. Runs `work` on this rank, then agrees with all others. If any rank threw, every rank throws the error
/// of the lowest rank that failed, with its type, reason and message. `work` must not call collectives on `comm`.
void together(MPI_Comm comm, const std::function<void()>& work);

/// *Collective*. As `together`, with `work` run on rank 0 alone.
void on_root(MPI_Comm comm, const std::function<void()>& work);

}  // namespace ritz::parallel
