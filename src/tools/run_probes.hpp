// probes.csv: t,NAME_ux,NAME_uy,NAME_uz,... with a row a state, 15 significant digits.
#pragma once
#include <Eigen/Core>

#include "ritz/scene/scene.hpp"
#include "run_table.hpp"

namespace ritz::tools {

class ProbeWriter {
 public:
  /// `matrix` as probe_matrix returns it. Throws InputError when the file cannot be created.
  ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes, Eigen::MatrixXd matrix);

  void row(double t, Eigen::Ref<const Eigen::VectorXd> z);
  TableFile& table() { return table_; }

 private:
  TableFile table_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd values_;
};

}  // namespace ritz::tools
