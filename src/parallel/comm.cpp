#include "ritz/parallel/comm.hpp"

namespace ritz::parallel {

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
