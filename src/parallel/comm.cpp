#include "ritz/parallel/comm.hpp"

#include <array>
#include <chrono>
#include <memory>
#include <new>
#include <thread>

namespace ritz::parallel {

using namespace std::chrono_literals;

int rank(MPI_Comm comm) {
  int r = 0;
  MPI_Comm_rank(comm, &r);
  return r;
}

int size(MPI_Comm comm) {
  int n = 0;
  MPI_Comm_size(comm, &n);
  return n;
}

Vote vote(MPI_Comm comm, bool yes) noexcept {
  // Counted, as a collective that fails for want of memory is done too: each rank once, and each no.
  constexpr std::int64_t no = std::int64_t{1} << 32;
  std::unique_ptr<std::array<std::int64_t, 2>> numbers(new (std::nothrow) std::array<std::int64_t, 2>{});
  if (!numbers) return Vote::alone;
  auto& [mine, all] = *numbers;
  mine = 1 + (yes ? 0 : no);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&mine, &all, 1, MPI_INT64_T, MPI_SUM, comm, &request);
  int done = 0;
  const auto limit = std::chrono::steady_clock::now() + 5s;
  if (yes) MPI_Wait(&request, MPI_STATUS_IGNORE);
  while (!yes && !done && std::chrono::steady_clock::now() < limit) {
    std::this_thread::sleep_for(2ms);
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
  if (!yes && !done) {
    numbers.release();  // MPI may still write there
    return Vote::alone;
  }
  if (all % no != size(comm)) return Vote::alone;
  return all < no ? Vote::all_yes : Vote::some_no;
}

void sum_in_place(MPI_Comm comm, Eigen::Ref<Eigen::MatrixXd> m) {
  if (m.outerStride() == m.rows()) {
    MPI_Allreduce(MPI_IN_PLACE, m.data(), static_cast<int>(m.size()), MPI_DOUBLE, MPI_SUM, comm);
    return;
  }
  Eigen::MatrixXd packed = m;
  sum_in_place(comm, packed);
  m = packed;
}

void broadcast(MPI_Comm comm, std::string& text, int root) {
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  broadcast(comm, bytes, root);
  text.assign(bytes.begin(), bytes.end());
}

void broadcast(MPI_Comm comm, std::vector<std::string>& texts, int root) {
  auto n = static_cast<std::int64_t>(texts.size());
  MPI_Bcast(&n, 1, MPI_INT64_T, root, comm);
  texts.resize(static_cast<std::size_t>(n));
  for (auto& text : texts) broadcast(comm, text, root);
}

}  // namespace ritz::parallel
