// Everything that a run leaves behind: a motion of each body with its .xdmf, the tables of the probes and of what the
// steps cost, and the summary.
#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "ritz/files/claim.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/motion.hpp"
#include "ritz/model/model.hpp"
#include "run_tables.hpp"

namespace ritz::tools {

using format::MotionPlan;

/// Takes the states of a run one by one, body after body, and writes those that are frames as displacements.
class Recorder {
 public:
  /// `frame_states` as frame_schedule returns it.
  explicit Recorder(std::vector<std::int64_t> frame_states) : frame_states_(std::move(frame_states)) {}

  /// The next body, whose motion is written to `output`. Its plan has a frame time for each frame state. `body` must
  /// outlive the recorder. All bodies are added before the first state.
  void add(const std::filesystem::path& output, const model::Body& body, const MotionPlan& plan);
  /// Has the table of the probes written too, those of each body by its matrix.
  void add_probes(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
                  std::vector<ProbedBody> bodies);
  /// Has the table of the steps' cost written too, of all bodies together.
  void add_timing(const std::filesystem::path& path);
  /// Has a summary written too.
  void add_summary(const std::filesystem::path& path);
  /// The summary's text, before the commit.
  void summary(const std::string& text);

  /// A state of body `body`, counted as they were added.
  void record(std::size_t body, double t, Eigen::Ref<const Eigen::VectorXd> z);
  /// Of the step that led to the state which is recorded next.
  void cost(std::size_t body, const world::StepCost& step);

  /// The displacements of the latest state, n x 3, m; of a body without vertices 0 x 3.
  const model::Points& latest(std::size_t body);

  /// Gives all files their names, which `claim` holds.
  void commit(const files::Claim& claim);

 private:
  struct Motion {
    const model::Body& body;
    format::ReducedMotion file;
    std::size_t next_frame = 0;
    std::int64_t state = 0;
    Eigen::VectorXd z;  ///< the latest state
    model::Points displacement;
  };

  std::vector<std::int64_t> frame_states_;
  std::deque<Motion> motions_;
  std::optional<ProbeWriter> probes_;
  std::optional<TimingWriter> timing_;
  std::optional<files::PartFile> summary_;
  world::StepCost cost_;  ///< of the bodies so far
};

}  // namespace ritz::tools
