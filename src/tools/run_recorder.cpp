#include "run_recorder.hpp"

#include <utility>

#include "ritz/files/interruption.hpp"
#include "ritz/files/names.hpp"
#include "ritz/runtime/reconstruction.hpp"

namespace ritz::tools {

Recorder::Recorder(const std::filesystem::path& output, const model::Body& body, const MotionPlan& plan,
                   std::vector<std::int64_t> frame_states)
    : body_(body),
      output_(output),
      motion_(output, body.geometry, plan),
      frame_states_(std::move(frame_states)),
      displacement_(body.geometry.points.rows(), 3) {}

void Recorder::add_probes(const std::vector<scene::Probe>& probes, Eigen::MatrixXd matrix) {
  probes_.emplace(files::table_beside(output_, "probes"), probes, std::move(matrix));
}

void Recorder::add_timing(const std::filesystem::path& path) { timing_.emplace(path); }

void Recorder::add_summary(const std::filesystem::path& path) { summary_.emplace(path); }

void Recorder::summary(const std::string& text) {
  summary_->out() << text;
  summary_->check();
}

void Recorder::record(double t, Eigen::Ref<const Eigen::VectorXd> z) {
  z_ = z;
  motion_.state(t, z);
  if (probes_) probes_->row(t, z);
  const auto state = state_++;
  if (next_frame_ == frame_states_.size() || frame_states_[next_frame_] != state) return;
  runtime::reconstruct(body_.basis, z, displacement_);
  motion_.frame(displacement_);
  ++next_frame_;
}

const model::Points& Recorder::latest() {
  if (displacement_.rows() > 0) runtime::reconstruct(body_.basis, z_, displacement_);
  return displacement_;
}

void Recorder::cost(const world::StepCost& step) {
  if (timing_) timing_->row(step);
}

void Recorder::commit(const files::Claim& claim) {
  motion_.finish();
  if (probes_) probes_->table().finish();
  if (timing_) timing_->table().finish();
  if (summary_) summary_->finish();
  claim.verify();
  const files::Uninterrupted together;
  if (probes_) probes_->table().publish();
  if (timing_) timing_->table().publish();
  if (summary_) summary_->publish();
  motion_.publish();
  claim.say_published();
}

}  // namespace ritz::tools
