#include "run_probes.hpp"

#include <utility>

namespace ritz::tools {

ProbeWriter::ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
                         Eigen::MatrixXd matrix)
    : table_(path), matrix_(std::move(matrix)), values_(matrix_.rows()) {
  table_.out() << 't';
  for (const auto& probe : probes)
    for (const auto* component : {"_ux", "_uy", "_uz"}) table_.out() << ',' << probe.name << component;
  table_.out() << '\n';
}

void ProbeWriter::row(double t, Eigen::Ref<const Eigen::VectorXd> z) {
  values_.noalias() = matrix_ * z;
  table_.out() << t;
  for (const double value : values_) table_.out() << ',' << value;
  table_.out() << '\n';
  table_.check();
}

}  // namespace ritz::tools
