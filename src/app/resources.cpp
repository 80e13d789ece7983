#include "ritz/app/resources.hpp"

#include <cstdio>
#include <fstream>

#include "ritz/base/shown.hpp"
#include "ritz/files/summary.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

double available_memory() {
  std::ifstream in("/proc/meminfo");
  for (std::string word; in >> word;)
    if (double kilobytes = 0; word == "MemAvailable:" && in >> kilobytes) return 1024 * kilobytes;
  return 1e300;
}

}  // namespace

double free_memory_per_rank(MPI_Comm comm) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  const double share = available_memory() / parallel::size(machine);
  MPI_Comm_free(&machine);
  return parallel::min(comm, share);
}

Memory peak_memory(MPI_Comm comm) {
  const double mine = files::peak_memory();
  return {parallel::max(comm, mine), parallel::sum(comm, mine)};
}

std::string peak_memory_line(MPI_Comm comm) {
  const double total = peak_memory(comm).all_ranks;
  return formatted("peak memory %.2f GB over %s", total / 1e9, counted(parallel::size(comm), "rank", "ranks").c_str());
}

}  // namespace ritz::app
