#include "ritz/app/full_file.hpp"

#include <algorithm>
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

std::span<const double> numbers(const parallel::RowMatrix& rows) {
  return {rows.data(), static_cast<std::size_t>(rows.size())};
}

/// All ranks' values on rank 0.
std::vector<std::int64_t> gathered(MPI_Comm comm, std::span<const std::int64_t> mine) {
  std::vector<std::int64_t> all;
  parallel::in_rank_order<std::int64_t>(comm, mine,
                                        [&](auto piece) { all.insert(all.end(), piece.begin(), piece.end()); });
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
  parallel::in_rank_order<double>(comm_, numbers(slice), [&](auto piece) { stream.append(piece); });
  parallel::on_root(comm_, [&] { stream.close(); });
}

void FullFile::frame(mesh::VertexRef u) {
  const auto slice = order_.to_file(comm_, by_vertex(u));
  parallel::in_rank_order<double>(comm_, numbers(slice), [&](auto piece) { file_->frames().append(piece); });
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
