#include "run_recorder.hpp"

#include <cerrno>
#include <limits>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/runtime/reconstruction.hpp"

namespace ritz::tools {
namespace {

void refuse_beyond_single(const model::Points& displacement, double t) {
  const double largest = displacement.size() > 0 ? displacement.cwiseAbs().maxCoeff() : 0;
  if (largest > static_cast<double>(std::numeric_limits<float>::max()))
    throw NumericalError("the frame at t = " + shown(t) + " has a displacement of " + shown(largest) +
                         " m, which single precision cannot hold: say --double-frames");
}

}  // namespace

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
    : table_(path) {
  const auto names = scene::probe_columns(probes);
  row_.resize(std::ssize(names));
  table_.out() << 't';
  for (const auto& name : names) table_.out() << ',' << name;
  table_.out() << '\n';
  for (auto& body : bodies) {
    Probed probed{.matrix = std::move(body.matrix), .columns = {}};
    Eigen::Index first = 0, own = 0;
    for (const auto& probe : probes) {
      for (const auto quantity : probe.quantities) {
        if (probe.body == body.name) probed.columns.push_back({first, own, quantity});
        first += 3;
      }
      if (probe.body == body.name) ++own;
    }
    bodies_.push_back(std::move(probed));
  }
}

void ProbeWriter::take(std::size_t body, const world::Moment& now) {
  const auto coordinates = [&](scene::Quantity quantity) -> const Eigen::VectorXd& {
    if (quantity == scene::Quantity::displacement) return now.z;
    return quantity == scene::Quantity::velocity ? now.velocity : now.acceleration;
  };
  const auto& [matrix, all] = bodies_[body];
  for (const auto& columns : all)
    row_.segment<3>(columns.first).noalias() = matrix.middleRows<3>(3 * columns.probe) * coordinates(columns.quantity);
  if (body + 1 < bodies_.size()) return;
  table_.out() << now.t;
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
                      .frames = plan.frames,
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

void Recorder::record(std::size_t body, const world::Moment& now) {
  auto& motion = motions_[body];
  motion.z = now.z;
  motion.file.state(now.t, now.z, now.velocity);
  if (probes_) probes_->take(body, now);
  const auto state = motion.state++;
  if (motion.next_frame == frame_states_.size() || frame_states_[motion.next_frame] != state) return;
  runtime::reconstruct(motion.body.basis, now.z, motion.displacement);
  if (motion.frames == format::Stored::float32) refuse_beyond_single(motion.displacement, now.t);
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
