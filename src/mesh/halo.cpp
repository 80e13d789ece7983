#include "ritz/mesh/halo.hpp"

#include <algorithm>

#include "ritz/mesh/mesh.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

Eigen::Index count(const std::vector<SharedVertices>& parts) {
  Eigen::Index total = 0;
  for (const auto& part : parts) total += std::ssize(part.vertices);
  return total;
}

}  // namespace

Halo::Halo(const Mesh& mesh) {
  const auto firsts = parallel::gather_all(mesh.comm, std::vector<Index>{mesh.first});
  std::vector<std::vector<Index>> asked(firsts.size());
  std::vector<std::vector<int>> ghosts(firsts.size());
  for (int v = mesh.owned; v < mesh.local_vertices(); ++v) {
    const Index global = mesh.global[static_cast<std::size_t>(v)];
    const auto owner = static_cast<std::size_t>(std::ranges::upper_bound(firsts, global) - firsts.begin() - 1);
    asked[owner].push_back(global);
    ghosts[owner].push_back(v);
  }
  const auto wanted = parallel::exchange(mesh.comm, asked);
  for (std::size_t p = 0; p < firsts.size(); ++p) {
    const int rank = static_cast<int>(p);
    if (!ghosts[p].empty()) received_.push_back({rank, std::move(ghosts[p])});
    if (wanted[p].empty()) continue;
    sent_.push_back({rank, {}});
    for (const Index global : wanted[p]) sent_.back().vertices.push_back(static_cast<int>(global - mesh.first));
  }
}

void Halo::fill_ghosts(MPI_Comm comm, LocalRows& local, int numbers) const {
  const Eigen::Index width = numbers * local.cols();
  out_.resize(static_cast<std::size_t>(width * count(sent_)));
  in_.resize(static_cast<std::size_t>(width * count(received_)));
  requests_.clear();
  double* in = in_.data();
  for (const auto& [rank, vertices] : received_) {
    const auto length = width * std::ssize(vertices);
    MPI_Irecv(in, static_cast<int>(length), MPI_DOUBLE, rank, 0, comm, &requests_.emplace_back());
    in += length;
  }
  double* out = out_.data();
  for (const auto& [rank, vertices] : sent_) {
    double* const begin = out;
    for (const int v : vertices)
      for (Eigen::Index j = 0; j < local.cols(); ++j)
        out = std::copy_n(&local(static_cast<Eigen::Index>(numbers) * v, j), numbers, out);
    MPI_Isend(begin, static_cast<int>(out - begin), MPI_DOUBLE, rank, 0, comm, &requests_.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  const double* next = in_.data();
  for (const auto& part : received_)
    for (const int v : part.vertices)
      for (Eigen::Index j = 0; j < local.cols(); ++j, next += numbers)
        std::copy_n(next, numbers, &local(static_cast<Eigen::Index>(numbers) * v, j));
}

LocalRows with_ghosts(const Mesh& mesh, VertexRef u, int numbers) {
  LocalRows local(static_cast<Eigen::Index>(numbers) * mesh.local_vertices(), u.cols());
  local.topRows(u.rows()) = u;
  mesh.halo.fill_ghosts(mesh.comm, local, numbers);
  return local;
}

}  // namespace ritz::mesh
