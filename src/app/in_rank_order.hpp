// Rank 0 writes what all ranks hold, the piece of one rank after that of another.
#pragma once
#include <exception>
#include <functional>
#include <span>
#include <vector>

#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {

/// *Collective*. Calls `write` on rank 0 with the values of rank 0, 1, ...; no rank holds more than its own piece and
/// one other. An exception of `write` is thrown on all ranks.
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
  if (parallel::rank(comm) == 0) {
    attempt(mine);
    for (int p = 1; p < parallel::size(comm); ++p) {
      MPI_Status status;
      int count = 0;
      MPI_Probe(p, 0, comm, &status);
      MPI_Get_count(&status, parallel::mpi_type<T>(), &count);
      std::vector<T> piece(static_cast<std::size_t>(count));
      MPI_Recv(piece.data(), count, parallel::mpi_type<T>(), p, 0, comm, MPI_STATUS_IGNORE);
      attempt(piece);
    }
  } else {
    MPI_Send(mine.data(), static_cast<int>(mine.size()), parallel::mpi_type<T>(), 0, 0, comm);
  }
  parallel::on_root(comm, [&] {
    if (failed) std::rethrow_exception(failed);
  });
}

}  // namespace ritz::app
