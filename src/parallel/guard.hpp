// A failure on one rank becomes everybody's before the next collective.
#pragma once
#include <mpi.h>

#include <functional>

namespace ritz::parallel {

/// Runs `work` on this rank, then agrees with all others. If any rank threw, every rank throws the error of the lowest
/// rank that failed, with its kind, reason and message. `work` must not call collectives on `comm`. *Collective*.
void together(MPI_Comm comm, const std::function<void()>& work);

/// `together`, with `work` run on rank 0 alone. *Collective*.
void on_root(MPI_Comm comm, const std::function<void()>& work);

}  // namespace ritz::parallel
