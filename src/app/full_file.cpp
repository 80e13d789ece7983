#include "ritz/app/full_file.hpp"

#include "ritz/app/in_rank_order.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/motion_dataset.hpp"
#include "ritz/format/schema.hpp"
#include "ritz/format/xdmf.hpp"

namespace ritz::app {
namespace {

/// The share of a checksum of vertices from `first` on.
std::uint64_t checksum_of(std::span<const double> piece, hsize_t first) {
  return format::checksum(std::as_bytes(piece), 3 * sizeof(double), static_cast<std::int64_t>(first));
}

/// HDF5 1.10's layout, in which its own records carry checksums.
format::Properties checked_layout() {
  format::Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  return access;
}

}  // namespace

std::filesystem::path xdmf_path(std::filesystem::path path) {
  if (path.extension() == ".xdmf")
    throw InputError("-output " + path.string() +
                     " names the HDF5 file, beside which an .xdmf is written: end it in .h5");
  return path.replace_extension(".xdmf");
}

FullFile::FullFile(const std::filesystem::path& path, const mesh::Mesh& mesh, const fem::Materials& materials,
                   const FullPlan& plan)
    : comm_(mesh.comm),
      order_(file_geometry(mesh, materials, config::StoredRows::all)),
      part_(comm_, path),
      frames_planned_(plan.frame_times.size()) {
  parallel::on_root(comm_, [&] {
    file_ = format::File(H5Fcreate(part_.part().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, checked_layout().get()));
    format::require_written(static_cast<bool>(file_));
    format::write_attribute(file_.get(), "format", "ritz-motion 1");
    const auto states = static_cast<hsize_t>(plan.times.size());
    format::write_block(format::create_floats(file_.get(), "times", {states}, plan.time_units), {0}, {states},
                        plan.times.data());
  });
  if (frames_planned_ > 0) begin_frames(path, plan);
}

void FullFile::begin_frames(const std::filesystem::path& path, const FullPlan& plan) {
  const auto& geometry = order_.geometry;
  const auto topology = format::mixed_topology(geometry.cells);
  const auto n = static_cast<hsize_t>(order_.slices.vertices.total), frames = static_cast<hsize_t>(frames_planned_);
  std::vector<std::int64_t> entries, ids;
  in_rank_order<std::int64_t>(comm_, topology,
                              [&](auto piece) { entries.insert(entries.end(), piece.begin(), piece.end()); });
  in_rank_order<std::int64_t>(comm_, geometry.vertex_ids,
                              [&](auto piece) { ids.insert(ids.end(), piece.begin(), piece.end()); });
  write_vertices("points", geometry.points, "m");
  std::string text;
  parallel::on_root(comm_, [&] {
    const hid_t file = file_.get();
    format::write_integers(file, "cells", entries);
    format::write_integers(file, "vertex_ids", ids);
    format::write_block(format::create_floats(file, "frame_times", {frames}, plan.time_units), {0}, {frames},
                        plan.frame_times.data());
    snapshots_ = format::create_floats(file, "snapshots", {frames, 3 * n}, "m");
    format::view_part(file, "displacement", {frames, n, 3}, {"/snapshots", {frames, 3 * n}, {0, 0}, {frames, 3 * n}},
                      "m");
    for (hsize_t i = 0; i < frames; ++i)
      format::view_part(file, format::frame_name(i), {n, 3}, {"/snapshots", {frames, 3 * n}, {i, 0}, {1, 3 * n}}, "m");
    const format::XdmfSize size{.vertices = order_.slices.vertices.total,
                                .cells = order_.slices.cells.total,
                                .topology = static_cast<std::int64_t>(entries.size())};
    text = format::xdmf_text(path.filename().string(), size, plan.frame_times);
  });
  xdmf_.emplace(comm_, xdmf_path(path)).write(text);
}

void FullFile::write_vertices(const std::string& name, const parallel::RowMatrix& slice, const std::string& units) {
  const auto n = static_cast<hsize_t>(order_.slices.vertices.total);
  format::Dataset dataset;
  hsize_t row = 0;
  std::uint64_t sum = 0;
  parallel::on_root(comm_, [&] { dataset = format::create_floats(file_.get(), name.c_str(), {n, 3}, units); });
  in_rank_order<double>(comm_, {slice.data(), static_cast<std::size_t>(slice.size())}, [&](auto piece) {
    const hsize_t rows = piece.size() / 3;
    format::write_block(dataset, {row, 0}, {rows, 3}, piece.data());
    sum += checksum_of(piece, row);
    row += rows;
  });
  parallel::on_root(comm_, [&] { format::write_attribute(dataset.get(), format::schema::checksum, sum); });
}

void FullFile::frame(mesh::VertexRef u) {
  const auto slice = order_.to_file(comm_, by_vertex(u));
  hsize_t at = 0;
  in_rank_order<double>(comm_, {slice.data(), static_cast<std::size_t>(slice.size())}, [&](auto piece) {
    format::write_block(snapshots_, {frames_, at}, {1, piece.size()}, piece.data());
    snapshots_sum_ += checksum_of(piece, frames_ * static_cast<hsize_t>(order_.slices.vertices.total) + at / 3);
    at += piece.size();
  });
  ++frames_;
}

void FullFile::keep(const LastState& state, const std::string& problem_checksum) {
  parallel::on_root(comm_, [&] {
    const format::Group group(H5Gcreate2(file_.get(), "state", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    format::require_written(static_cast<bool>(group));
    for (const auto& [name, value] : state.numbers) format::write_attribute(group.get(), name.c_str(), value);
    format::write_attribute(group.get(), "problem_checksum", problem_checksum);
    format::write_attribute(group.get(), "integrator", state.integrator);
    format::write_attribute(group.get(), "kind", std::string(state.kind == StateKind::moving ? "moving" : "at_rest"));
  });
  write_vertices("state/displacement", order_.to_file(comm_, by_vertex(state.u)), "m");
  write_vertices("state/velocity", order_.to_file(comm_, by_vertex(state.v)), "m/s");
  write_vertices("state/acceleration", order_.to_file(comm_, by_vertex(state.a)), "m/s2");
}

void FullFile::finish() {
  parallel::on_root(comm_, [&] {
    if (snapshots_) format::write_attribute(snapshots_.get(), format::schema::checksum, snapshots_sum_);
    format::require_written(snapshots_.close() && H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0 && file_.close());
  });
  part_.finish();
  if (xdmf_) xdmf_->finish();
}

void FullFile::publish() {
  if (xdmf_) xdmf_->publish();
  part_.publish();
}

}  // namespace ritz::app
