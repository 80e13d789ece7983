#include "run_motion.hpp"

#include "ritz/base/error.hpp"
#include "ritz/format/motion_dataset.hpp"
#include "ritz/format/xdmf.hpp"

namespace ritz::tools {
namespace {

constexpr Eigen::Index states_at_once = 256;

}  // namespace

std::filesystem::path xdmf_path(std::filesystem::path path) {
  if (path.extension() == ".xdmf")
    throw InputError("--output " + path.string() +
                     " names the HDF5 file, beside which an .xdmf is written: end it in .h5");
  return path.replace_extension(".xdmf");
}

MotionWriter::MotionWriter(const std::filesystem::path& path, const model::Geometry& geometry, const MotionPlan& plan)
    : part_(path),
      file_(H5Fcreate(part_.part().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)),
      pending_times_(states_at_once),
      pending_z_(states_at_once, plan.columns) {
  format::require_written(static_cast<bool>(file_));
  format::write_attribute(file_.get(), "format", "ritz-motion 1");
  const auto states = static_cast<hsize_t>(plan.states), columns = static_cast<hsize_t>(plan.columns);
  times_ = format::create_floats(file_.get(), "times", {states}, plan.time_units);
  z_ = format::create_floats(file_.get(), "z", {states, columns}, "sqrt(kg) m");
  if (!plan.frame_times.empty()) begin_frames(geometry, plan);
}

void MotionWriter::begin_frames(const model::Geometry& geometry, const MotionPlan& plan) {
  const auto n = static_cast<hsize_t>(geometry.points.rows()), frames = static_cast<hsize_t>(plan.frame_times.size());
  const auto topology = format::mixed_topology(geometry.cells);
  format::write_integers(file_.get(), "cells", topology);
  format::write_integers(file_.get(), "vertex_ids", geometry.vertex_ids);
  format::write_block(format::create_floats(file_.get(), "points", {n, 3}, "m"), {0, 0}, {n, 3},
                      geometry.points.data());
  format::write_block(format::create_floats(file_.get(), "frame_times", {frames}, plan.time_units), {0}, {frames},
                      plan.frame_times.data());
  displacement_ = format::create_floats(file_.get(), "displacement", {frames, n, 3}, "m");
  for (hsize_t frame = 0; frame < frames; ++frame)
    format::view_entry(file_.get(), format::frame_name(frame), "/displacement", {frames, n, 3}, frame, "m");

  xdmf_.emplace(xdmf_path(part_.path()));
  const format::XdmfSize size{.vertices = geometry.points.rows(),
                              .cells = static_cast<std::int64_t>(geometry.cells.vtk_types.size()),
                              .topology = static_cast<std::int64_t>(topology.size())};
  xdmf_->write(format::xdmf_text(part_.path().filename().string(), size, plan.frame_times));
}

void MotionWriter::state(double t, Eigen::Ref<const Eigen::VectorXd> z) {
  pending_times_[pending_] = t;
  pending_z_.row(pending_) = z;
  if (++pending_ == states_at_once) flush_states();
}

void MotionWriter::flush_states() {
  const auto count = static_cast<hsize_t>(pending_);
  if (count == 0) return;
  format::write_block(times_, {states_}, {count}, pending_times_.data());
  format::write_block(z_, {states_, 0}, {count, static_cast<hsize_t>(pending_z_.cols())}, pending_z_.data());
  states_ += count;
  pending_ = 0;
}

void MotionWriter::frame(const model::Points& displacement) {
  format::write_block(displacement_, {frames_++, 0, 0}, {1, static_cast<hsize_t>(displacement.rows()), 3},
                      displacement.data());
}

void MotionWriter::finish() {
  flush_states();
  for (auto* dataset : {&times_, &z_, &displacement_}) format::require_written(dataset->close());
  format::require_written(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0 && file_.close());
  part_.finish();
  if (xdmf_) xdmf_->finish();
}

void MotionWriter::publish() {
  if (xdmf_) xdmf_->publish();
  part_.publish();
}

}  // namespace ritz::tools
