// Collective operations over MPI. Everything here is *Collective* on the communicator that is passed, except rank and
// size.
#pragma once
#include <mpi.h>

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "ritz/base/vote.hpp"

namespace ritz::parallel {

int rank(MPI_Comm comm);
int size(MPI_Comm comm);

/// Whether all ranks pass true. A rank that passes false, because something failed there, waits only seconds for the
/// others; if they do not come it gets Vote::alone, and can only call MPI_Abort.
Vote vote(MPI_Comm comm, bool yes) noexcept;

template <class T>
MPI_Datatype mpi_type() {
  if constexpr (std::is_same_v<T, double>) return MPI_DOUBLE;
  else if constexpr (std::is_same_v<T, std::int64_t>) return MPI_INT64_T;
  else if constexpr (std::is_same_v<T, std::uint64_t>) return MPI_UINT64_T;
  else if constexpr (std::is_same_v<T, std::int32_t>) return MPI_INT32_T;
  else if constexpr (std::is_same_v<T, std::uint8_t>) return MPI_UINT8_T;
  else static_assert(!sizeof(T), "no MPI type for this");
}

template <class T>
T reduce(MPI_Comm comm, T value, MPI_Op op) {
  T result{};
  MPI_Allreduce(&value, &result, 1, mpi_type<T>(), op, comm);
  return result;
}

/// The sum, the minimum and the maximum over all ranks, replicated.
template <class T>
T sum(MPI_Comm comm, T value) {
  return reduce(comm, value, MPI_SUM);
}
template <class T>
T min(MPI_Comm comm, T value) {
  return reduce(comm, value, MPI_MIN);
}
template <class T>
T max(MPI_Comm comm, T value) {
  return reduce(comm, value, MPI_MAX);
}

/// The sum of `value` over all lower ranks; 0 on rank 0.
template <class T>
T sum_before(MPI_Comm comm, T value) {
  T result{};
  MPI_Exscan(&value, &result, 1, mpi_type<T>(), MPI_SUM, comm);
  return rank(comm) == 0 ? T{} : result;
}

/// m := the sum of m over all ranks; the shape is the same on all.
void sum_in_place(MPI_Comm comm, Eigen::Ref<Eigen::MatrixXd> m);

/// Copies the value of rank `root` to all ranks.
template <class T>
void broadcast(MPI_Comm comm, std::vector<T>& values, int root = 0) {
  auto n = static_cast<std::int64_t>(values.size());
  MPI_Bcast(&n, 1, MPI_INT64_T, root, comm);
  values.resize(static_cast<std::size_t>(n));
  MPI_Bcast(values.data(), static_cast<int>(n), mpi_type<T>(), root, comm);
}

void broadcast(MPI_Comm comm, std::string& text, int root = 0);
void broadcast(MPI_Comm comm, std::vector<std::string>& texts, int root = 0);

/// The values of all ranks, concatenated in the order of ranks.
template <class T>
std::vector<T> gather_all(MPI_Comm comm, const std::vector<T>& mine) {
  const int n = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(size(comm))), starts(counts.size());
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  int total = 0;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    starts[p] = total;
    total += counts[p];
  }
  std::vector<T> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), n, mpi_type<T>(), all.data(), counts.data(), starts.data(), mpi_type<T>(), comm);
  return all;
}

/// Sends outgoing[p] to rank p, and returns what each rank sent here: entry p comes from rank p.
template <class T>
std::vector<std::vector<T>> exchange(MPI_Comm comm, const std::vector<std::vector<T>>& outgoing) {
  const auto ranks = outgoing.size();
  std::vector<int> send(ranks), receive(ranks);
  for (std::size_t p = 0; p < ranks; ++p) send[p] = static_cast<int>(outgoing[p].size());
  MPI_Alltoall(send.data(), 1, MPI_INT, receive.data(), 1, MPI_INT, comm);
  std::vector<std::vector<T>> incoming(ranks);
  std::vector<MPI_Request> requests;
  for (std::size_t p = 0; p < ranks; ++p) {
    incoming[p].resize(static_cast<std::size_t>(receive[p]));
    if (receive[p] > 0)
      MPI_Irecv(incoming[p].data(), receive[p], mpi_type<T>(), static_cast<int>(p), 0, comm, &requests.emplace_back());
  }
  for (std::size_t p = 0; p < ranks; ++p)
    if (send[p] > 0)
      MPI_Isend(outgoing[p].data(), send[p], mpi_type<T>(), static_cast<int>(p), 0, comm, &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return incoming;
}

}  // namespace ritz::parallel
