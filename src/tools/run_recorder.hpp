// Everything that a run leaves behind: motion.h5, motion.xdmf, the tables of its probes and of what its steps cost.
#pragma once
#include <optional>
#include <vector>

#include "ritz/files/claim.hpp"
#include "ritz/format/motion.hpp"
#include "ritz/model/model.hpp"
#include "run_probes.hpp"
#include "run_timing.hpp"

namespace ritz::tools {

using format::MotionPlan;

/// Takes the states of a run one by one and writes those that are frames as displacements.
class Recorder {
 public:
  /// `frame_states` as frame_schedule returns it, one for each of the plan's frame times. `body` must outlive it.
  Recorder(const std::filesystem::path& output, const model::Body& body, const MotionPlan& plan,
           std::vector<std::int64_t> frame_states);

  /// Has the table of the probes written too, beside the output.
  void add_probes(const std::vector<scene::Probe>& probes, Eigen::MatrixXd matrix);

  /// Has the table of the steps' cost written too.
  void add_timing(const std::filesystem::path& path);

  /// Has a summary written too.
  void add_summary(const std::filesystem::path& path);
  /// The summary's text, before the commit.
  void summary(const std::string& text);

  void record(double t, Eigen::Ref<const Eigen::VectorXd> z);
  /// Of the step that led to the state which is recorded next.
  void cost(const world::StepCost& step);

  /// The displacements of the latest state, n x 3, m; of a body without vertices 0 x 3.
  const model::Points& latest();

  /// Gives all files their names, which `claim` holds.
  void commit(const files::Claim& claim);

 private:
  const model::Body& body_;
  std::filesystem::path output_;
  format::ReducedMotion motion_;
  std::optional<ProbeWriter> probes_;
  std::optional<TimingWriter> timing_;
  std::optional<TableFile> summary_;
  std::vector<std::int64_t> frame_states_;
  std::size_t next_frame_ = 0;
  std::int64_t state_ = 0;
  Eigen::VectorXd z_;  ///< the latest state
  model::Points displacement_;
};

}  // namespace ritz::tools
