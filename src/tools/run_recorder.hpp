// Everything that a run leaves behind: a motion of each body with its .xdmf, the tables of the probes and of what the
// steps cost, and the summary. A table grows by one row for each state or step, and gets its name when it is complete.
#pragma once
#include <Eigen/Core>
#include <deque>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "ritz/files/claim.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/motion.hpp"
#include "ritz/model/model.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/world/run.hpp"

namespace ritz::tools {

class TableFile {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TableFile(const std::filesystem::path& path);

  /// The stream to which rows are written, with 15 digits for each number.
  std::ostream& out() { return out_; }
  /// To be called after each row. Throws NumericalError when the disk did not take what it was given so far.
  void check();

  /// Closes it and brings it to the disk. Throws NumericalError when not all could be written.
  void finish();
  void publish() { file_.publish(); }

 private:
  files::PartFile file_;
  std::ofstream out_;
};

/// The probes of one body.
struct ProbedBody {
  std::string name;
  Eigen::MatrixXd matrix;  ///< as probe_matrix returns it for this body's probes, in the scene's order
};

/// probes.csv: t and the columns of scene::probe_columns, with one row for each state, 15 significant digits.
class ProbeWriter {
 public:
  /// The columns are in the order of the scene. Throws InputError when the file cannot be created.
  ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
              std::vector<ProbedBody> bodies);

  /// Takes the state of body number `body`; that of the last body completes the row.
  void take(std::size_t body, const world::Moment& now);
  TableFile& table() { return table_; }

 private:
  /// Three columns of the table.
  struct Columns {
    Eigen::Index first;  ///< in the table, behind t
    Eigen::Index probe;  ///< of the body's own
    scene::Quantity quantity;
  };
  struct Probed {
    Eigen::MatrixXd matrix;
    std::vector<Columns> columns;
  };

  TableFile table_;
  std::vector<Probed> bodies_;
  Eigen::VectorXd row_;
};

/// t,microseconds,iterations,rejected with one row for each step.
class TimingWriter {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TimingWriter(const std::filesystem::path& path);

  void row(const world::StepCost& step);
  TableFile& table() { return table_; }

 private:
  TableFile table_;
};

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
  void record(std::size_t body, const world::Moment& now);
  /// Of the step that led to the state which is recorded next.
  void cost(std::size_t body, const world::StepCost& step);

  /// Where the motion of body `body` ended.
  void keep(std::size_t body, const format::ReducedState& end) { motions_[body].file.keep(end); }

  /// The displacements of the latest state, n x 3, m; of a body without vertices 0 x 3.
  const model::Points& latest(std::size_t body);

  /// Gives all files their names, which `claim` holds.
  void commit(const files::Claim& claim);

 private:
  struct Motion {
    const model::Body& body;
    format::ReducedMotion file;
    format::Stored frames;
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
