// Makes a failure on one rank a failure on all ranks, before the next collective call.
#pragma once
#include <mpi.h>

#include <exception>
#include <functional>
#include <span>
#include <vector>

#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {

/// *Collective*. Runs `work` on this rank, then agrees with all others. If any rank threw, every rank throws the error
/// of the lowest rank that failed, with its type, reason and message. `work` must not call collectives on `comm`.
void together(MPI_Comm comm, const std::function<void()>& work);

/// *Collective*. As `together`, with `work` run on rank 0 alone.
void on_root(MPI_Comm comm, const std::function<void()>& work);

/// *Collective*. Rank 0 writes what all ranks hold, the piece of one rank after that of another: calls `write` on rank
/// 0 with the values of rank 0, 1, ...; no rank holds more than its own piece and one other. An exception of `write` is
/// thrown on all ranks.
template <class T>
void in_rank_order(MPI_Comm comm, std::span<const T> mine, const std::function<void(std::span<const T>)>& write) {
  std::exception_ptr failed;
  const auto attempt = [&](std::span<const T> piece) {
    try {
      if (!failed) write(piece);
    } catch (...) {
      failed = std::current_exception();
    }
  };
  if (rank(comm) == 0) {
    attempt(mine);
    for (int p = 1; p < size(comm); ++p) {
      MPI_Status status;
      int count = 0;
      MPI_Probe(p, 0, comm, &status);
      MPI_Get_count(&status, mpi_type<T>(), &count);
      std::vector<T> piece(static_cast<std::size_t>(count));
      MPI_Recv(piece.data(), count, mpi_type<T>(), p, 0, comm, MPI_STATUS_IGNORE);
      attempt(piece);
    }
  } else {
    MPI_Send(mine.data(), static_cast<int>(mine.size()), mpi_type<T>(), 0, 0, comm);
  }
  on_root(comm, [&] {
    if (failed) std::rethrow_exception(failed);
  });
}

}  // namespace ritz::parallel
