// The tables that ritz-run writes beside a motion. A table grows by one row for each state or step, and gets its name
// when it is complete.
#pragma once
#include <Eigen/Core>
#include <fstream>
#include <string>
#include <vector>

#include "ritz/files/part_file.hpp"
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

/// probes.csv: t,NAME_ux,NAME_uy,NAME_uz,... with one row for each state, 15 significant digits.
class ProbeWriter {
 public:
  /// The columns are in the order of the scene. Throws InputError when the file cannot be created.
  ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
              std::vector<ProbedBody> bodies);

  /// Takes the state of body number `body`; that of the last body completes the row.
  void take(std::size_t body, double t, Eigen::Ref<const Eigen::VectorXd> z);
  TableFile& table() { return table_; }

 private:
  struct Columns {
    Eigen::MatrixXd matrix;
    std::vector<Eigen::Index> probes;  ///< which of the scene's they are
    Eigen::VectorXd values;
  };

  TableFile table_;
  std::vector<Columns> bodies_;
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

}  // namespace ritz::tools
