// probes.csv: t,NAME_ux,NAME_uy,NAME_uz,... with a row a state, 15 significant digits.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "ritz/scene/scene.hpp"
#include "run_table.hpp"

namespace ritz::tools {

/// The probes of one body.
struct ProbedBody {
  std::string name;
  Eigen::MatrixXd matrix;  ///< as probe_matrix returns it for this body's probes, in the scene's order
};

class ProbeWriter {
 public:
  /// Columns stand in the scene's order, whosever they are. Throws InputError when the file cannot be created.
  ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
              std::vector<ProbedBody> bodies);

  /// The state of a body, counted as they were given; that of the last body completes the row.
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

}  // namespace ritz::tools
