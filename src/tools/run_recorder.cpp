#include "run_recorder.hpp"

#include <cerrno>
#include <utility>

#include "ritz/files/interruption.hpp"
#include "ritz/runtime/reconstruction.hpp"

namespace ritz::tools {

TableFile::TableFile(const std::filesystem::path& path) : file_(path), out_(file_.part(), std::ios::binary) {
  out_.precision(15);
  check();
}

void TableFile::check() {
  if (!out_) files::fail_to_write(file_.path(), errno);
}

void TableFile::finish() {
  errno = 0;
  out_.close();
  check();
  file_.finish();
}

ProbeWriter::ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
                         std::vector<ProbedBody> bodies)
    : table_(path), row_(3 * std::ssize(probes)) {
  table_.out() << 't';
  for (const auto& probe : probes)
    for (const auto* component : {"_ux", "_uy", "_uz"}) table_.out() << ',' << probe.name << component;
  table_.out() << '\n';
  for (auto& body : bodies) {
    Columns columns{.matrix = std::move(body.matrix), .probes = {}, .values = {}};
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (probes[i].body == body.name) columns.probes.push_back(static_cast<Eigen::Index>(i));
    columns.values.resize(columns.matrix.rows());
    bodies_.push_back(std::move(columns));
  }
}

void ProbeWriter::take(std::size_t body, double t, Eigen::Ref<const Eigen::VectorXd> z) {
  auto& columns = bodies_[body];
  columns.values.noalias() = columns.matrix * z;
  Eigen::Index from = 0;
  for (const auto probe : columns.probes) {
    row_.segment<3>(3 * probe) = columns.values.segment<3>(from);
    from += 3;
  }
  if (body + 1 < bodies_.size()) return;
  table_.out() << t;
  for (const double value : row_) table_.out() << ',' << value;
  table_.out() << '\n';
  table_.check();
}

TimingWriter::TimingWriter(const std::filesystem::path& path) : table_(path) {
  table_.out() << "t,microseconds,iterations,rejected\n";
}

void TimingWriter::row(const world::StepCost& step) {
  table_.out() << step.t << ',' << 1e6 * step.seconds << ',' << step.iterations << ',' << step.rejected << '\n';
  table_.check();
}

void Recorder::add(const std::filesystem::path& output, const model::Body& body, const MotionPlan& plan) {
  motions_.push_back({.body = body,
                      .file = format::ReducedMotion(output, body.geometry, plan),
                      .z = {},
                      .displacement = model::Points(body.geometry.points.rows(), 3)});
}

void Recorder::add_probes(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
                          std::vector<ProbedBody> bodies) {
  probes_.emplace(path, probes, std::move(bodies));
}

void Recorder::add_timing(const std::filesystem::path& path) { timing_.emplace(path); }

void Recorder::add_summary(const std::filesystem::path& path) { summary_.emplace(path); }

void Recorder::summary(const std::string& text) { summary_->write(text); }

void Recorder::record(std::size_t body, double t, Eigen::Ref<const Eigen::VectorXd> z) {
  auto& motion = motions_[body];
  motion.z = z;
  motion.file.state(t, z);
  if (probes_) probes_->take(body, t, z);
  const auto state = motion.state++;
  if (motion.next_frame == frame_states_.size() || frame_states_[motion.next_frame] != state) return;
  runtime::reconstruct(motion.body.basis, z, motion.displacement);
  motion.file.frame(motion.displacement);
  ++motion.next_frame;
}

void Recorder::cost(std::size_t body, const world::StepCost& step) {
  if (!timing_) return;
  if (body == 0) cost_ = {.t = step.t};
  cost_.seconds += step.seconds;
  cost_.iterations += step.iterations;
  cost_.rejected += step.rejected;
  if (body + 1 == motions_.size()) timing_->row(cost_);
}

const model::Points& Recorder::latest(std::size_t body) {
  auto& motion = motions_[body];
  if (motion.displacement.rows() > 0) runtime::reconstruct(motion.body.basis, motion.z, motion.displacement);
  return motion.displacement;
}

void Recorder::commit(const files::Claim& claim) {
  for (auto& motion : motions_) motion.file.finish();
  if (probes_) probes_->table().finish();
  if (timing_) timing_->table().finish();
  if (summary_) summary_->finish();
  claim.verify();
  const files::Uninterrupted together;
  if (probes_) probes_->table().publish();
  if (timing_) timing_->table().publish();
  if (summary_) summary_->publish();
  for (auto& motion : motions_) motion.file.publish();
  claim.say_published();
}

}  // namespace ritz::tools
