#include "ritz/format/motion.hpp"

#include <array>

#include "motion_dataset.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/names.hpp"
#include "ritz/format/schema.hpp"
#include "ritz/format/xdmf.hpp"

namespace ritz::format {
namespace {

namespace names = schema::motion;

/// HDF5 1.10's layout has checksums on HDF5's own records. The list is closed after the file is judged: a call that
/// succeeds wipes what HDF5 says of the one that failed.
File create_file(const std::filesystem::path& path) {
  const Properties access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
  require_written(static_cast<bool>(file));
  return file;
}

hsize_t length(std::int64_t count) { return static_cast<hsize_t>(count); }

}  // namespace

std::filesystem::path xdmf_path(std::filesystem::path path, const std::string& name) {
  if (path.extension() == ".xdmf")
    throw InputError(name + " names the HDF5 file, beside which an .xdmf is written: end it in .h5");
  return path.replace_extension(".xdmf");
}

MotionFile::MotionFile(const std::filesystem::path& path) : part_(path), file_(create_file(part_.part())) {
  attach_text(file_.get(), schema::format, names::format_name);
}

void MotionFile::show_frames(const StillBody& body, std::span<const double> frame_times, const std::string& time_units,
                             const std::string& name, const NumberStream& frames) {
  write_integers(file(), names::cells, body.topology);
  write_integers(file(), names::vertex_ids, body.vertex_ids);
  write_numbers(file(), names::frame_times, frame_times, time_units);
  const hsize_t n = length(body.vertices), count = frame_times.size();
  for (hsize_t i = 0; i < count; ++i)
    show(file(), frame_name(i), {n, 3}, {name, frames.shape(), i, 1, frames.stored()});
  if (name != names::displacement)
    show(file(), names::displacement, {count, n, 3}, {name, frames.shape(), 0, count, frames.stored()});

  const XdmfSize size{.vertices = body.vertices,
                      .cells = body.cells,
                      .topology = static_cast<std::int64_t>(body.topology.size()),
                      .frame_bytes = frames.stored() == Stored::float32 ? 4 : 8};
  xdmf_.emplace(xdmf_path(part_.path(), part_.path().string()));
  xdmf_->write(xdmf_text(part_.path().filename().string(), size, frame_times));
}

void MotionFile::finish() {
  require_written(H5Fflush(file(), H5F_SCOPE_GLOBAL) >= 0 && file_.close());
  part_.finish();
  if (xdmf_) xdmf_->finish();
}

void MotionFile::publish() {
  if (xdmf_) xdmf_->publish();
  part_.publish();
}

ReducedMotion::ReducedMotion(const std::filesystem::path& path, const model::Geometry& geometry, const MotionPlan& plan)
    : file_(path),
      times_(file_.file(), names::times, {length(plan.states)}, plan.time_units, Checked::by_row),
      z_(file_.file(), names::z, {length(plan.states), length(plan.columns)}, "sqrt(kg) m", Checked::by_row),
      velocity_(file_.file(), names::zdot, {length(plan.states), length(plan.columns)}, "sqrt(kg) m/s",
                Checked::by_row) {
  if (!plan.model_checksum.empty()) attach_text(file_.file(), names::model_checksum, plan.model_checksum);
  if (plan.frame_times.empty()) return;
  const hsize_t n = length(geometry.points.rows());
  NumberStream points(file_.file(), names::points, {n, 3}, "m");
  points.append({geometry.points.data(), static_cast<std::size_t>(geometry.points.size())});
  points.close();
  displacement_ =
      NumberStream(file_.file(), names::displacement, {plan.frame_times.size(), n, 3}, "m", Checked::no, plan.frames);
  const auto topology = mixed_topology(geometry.cells);
  const StillBody body{.vertices = geometry.points.rows(),
                       .cells = std::ssize(geometry.cells.vtk_types),
                       .topology = topology,
                       .vertex_ids = geometry.vertex_ids};
  file_.show_frames(body, plan.frame_times, plan.time_units, names::displacement, displacement_);
}

void ReducedMotion::state(double t, Eigen::Ref<const Eigen::VectorXd> z, Eigen::Ref<const Eigen::VectorXd> velocity) {
  times_.append({&t, 1});
  z_.append({z.data(), static_cast<std::size_t>(z.size())});
  velocity_.append({velocity.data(), static_cast<std::size_t>(velocity.size())});
}

void ReducedMotion::frame(const model::Points& displacement) {
  displacement_.append({displacement.data(), static_cast<std::size_t>(displacement.size())});
}

void ReducedMotion::keep(const ReducedState& state) {
  const Group group(H5Gcreate2(file_.file(), names::state, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  require_written(static_cast<bool>(group));
  for (const auto& [name, value] : state.numbers) attach(group.get(), name.c_str(), H5T_IEEE_F64LE, &value);
  attach_text(group.get(), names::integrator, state.integrator);
  attach_text(group.get(), names::scene_checksum, state.scene_checksum);
  attach(group.get(), names::steps, H5T_STD_I64LE, &state.steps);
  attach(group.get(), names::last_step, H5T_IEEE_F64LE, &state.last_step);
  const model::RowMatrix rows = state.history;
  NumberStream history(file_.file(), names::history,
                       {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())}, "z, and by 1/s and 1/s2",
                       Checked::by_row);
  history.append({rows.data(), static_cast<std::size_t>(rows.size())});
  history.close();
}

void ReducedMotion::finish() {
  for (auto* stream : {&times_, &z_, &velocity_, &displacement_}) stream->close();
  file_.finish();
}

FullMotion::FullMotion(const std::filesystem::path& path, std::int64_t vertices, const FullPlan& plan)
    : file_(path), vertices_(length(vertices)) {
  write_numbers(file_.file(), names::times, plan.times, plan.time_units);
}

void FullMotion::begin_frames(const StillBody& body, const FullPlan& plan) {
  frames_ =
      NumberStream(file_.file(), names::snapshots, {plan.frame_times.size(), 3 * vertices_}, "m", Checked::by_vertex);
  file_.show_frames(body, plan.frame_times, plan.time_units, names::snapshots, frames_);
}

void FullMotion::keep(const StateRecord& state) {
  const Group group(H5Gcreate2(file_.file(), names::state, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  require_written(static_cast<bool>(group));
  for (const auto& [name, value] : state.numbers) attach(group.get(), name.c_str(), H5T_IEEE_F64LE, &value);
  attach_text(group.get(), schema::problem_checksum, state.problem_checksum);
  attach_text(group.get(), names::integrator, state.integrator);
  attach_text(group.get(), names::kind, name(state.kind));
}

NumberStream FullMotion::array(VertexArray which) const {
  constexpr std::array<const char*, 4> units = {"m", "m", "m/s", "m/s2"};
  const auto at = static_cast<std::size_t>(which);
  return {file_.file(), names::vertex_arrays[at], {vertices_, 3}, units[at], Checked::by_vertex};
}

void FullMotion::finish() {
  frames_.close();
  file_.finish();
}

}  // namespace ritz::format
