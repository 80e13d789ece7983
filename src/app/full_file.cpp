#include "ritz/app/full_file.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <span>
#include <vector>

#include "ritz/base/error.hpp"
#include "ritz/format/motion_reader.hpp"
#include "ritz/format/xdmf.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {
namespace {

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

std::span<const double> numbers(const parallel::RowMatrix& rows) {
  return {rows.data(), static_cast<std::size_t>(rows.size())};
}

/// All ranks' values on rank 0.
std::vector<std::int64_t> gathered(MPI_Comm comm, std::span<const std::int64_t> mine) {
  std::vector<std::int64_t> all;
  in_rank_order<std::int64_t>(comm, mine, [&](auto piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

}  // namespace

FullFile::FullFile(const std::filesystem::path& path, const mesh::Mesh& mesh, const fem::Materials& materials,
                   const FullPlan& plan)
    : comm_(mesh.comm), order_(file_geometry(mesh, materials, config::StoredRows::all)) {
  parallel::on_root(comm_, [&] { file_.emplace(path, order_.slices.vertices.total, plan); });
  if (!plan.frame_times.empty()) begin_frames(plan);
}

void FullFile::begin_frames(const FullPlan& plan) {
  const auto topology = gathered(comm_, format::mixed_topology(order_.geometry.cells));
  const auto ids = gathered(comm_, order_.geometry.vertex_ids);
  write(format::VertexArray::points, order_.geometry.points);
  const format::StillBody body{.vertices = order_.slices.vertices.total,
                               .cells = order_.slices.cells.total,
                               .topology = topology,
                               .vertex_ids = ids};
  parallel::on_root(comm_, [&] { file_->begin_frames(body, plan); });
}

void FullFile::write(format::VertexArray array, const parallel::RowMatrix& slice) {
  format::NumberStream stream;
  parallel::on_root(comm_, [&] { stream = file_->array(array); });
  in_rank_order<double>(comm_, numbers(slice), [&](auto piece) { stream.append(piece); });
  parallel::on_root(comm_, [&] { stream.close(); });
}

void FullFile::frame(mesh::VertexRef u) {
  const auto slice = order_.to_file(comm_, by_vertex(u));
  in_rank_order<double>(comm_, numbers(slice), [&](auto piece) { file_->frames().append(piece); });
}

void FullFile::keep(const LastState& state, const std::string& problem_checksum) {
  parallel::on_root(comm_, [&] { file_->keep({state.kind, state.integrator, problem_checksum, state.numbers}); });
  write(format::VertexArray::displacement, order_.to_file(comm_, by_vertex(state.u)));
  write(format::VertexArray::velocity, order_.to_file(comm_, by_vertex(state.v)));
  write(format::VertexArray::acceleration, order_.to_file(comm_, by_vertex(state.a)));
}

void FullFile::finish() {
  parallel::on_root(comm_, [&] { file_->finish(); });
}

void FullFile::publish() {
  parallel::on_root(comm_, [&] { file_->publish(); });
}

std::string verify_last_state(MPI_Comm comm, const std::filesystem::path& path, const std::string& name) {
  std::string warning;
  parallel::on_root(comm, [&] {
    if (!format::LastStateReader(path, name).verify())
      warning = name + ": an earlier ritz-full wrote it without checksums, so damage in its last state goes unseen";
  });
  return warning;
}

LastState read_last_state(const std::filesystem::path& path, const std::string& name, const mesh::Mesh& mesh,
                          const std::string& problem_checksum) {
  LastState state;
  const auto slice = parallel::even_slice(mesh.comm, mesh.vertices_total);
  parallel::RowMatrix rows;
  parallel::together(mesh.comm, [&] {
    const auto refuse = [&](const std::string& why) { throw InputError(name + ": " + why); };
    const format::LastStateReader in(path, name);
    const auto record = in.record();
    if (record.problem_checksum != problem_checksum) refuse("it was written for another mesh, material or support");
    const auto& known = scene::integrator_names;
    if (record.integrator != "none" && std::ranges::find(known, record.integrator) == known.end())
      refuse("its last state is of the unknown integrator '" + record.integrator + "'");
    state.kind = record.kind;
    state.integrator = record.integrator;
    state.numbers = record.numbers;
    rows = in.rows(slice.first, slice.count, slice.total);
  });
  const std::vector<std::int64_t> order(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const auto mine = parallel::from_slices(mesh.comm, order, rows, mesh.vertices_total);
  Eigen::Index part = 0;
  for (mesh::VertexRows* column : {&state.u, &state.v, &state.a}) {
    const parallel::RowMatrix three = mine.middleCols(mesh::components * part++, mesh::components);
    *column = Eigen::Map<const algebra::Tall>(three.data(), three.size(), 1);
  }
  return state;
}

}  // namespace ritz::app
