#include "run_probes.hpp"

#include <stdexcept>
#include <utility>

namespace ritz::tools {

ProbeWriter::ProbeWriter(const std::filesystem::path& path, const std::vector<scene::Probe>& probes,
                         Eigen::MatrixXd matrix)
    : file_(path), out_(file_.part()), matrix_(std::move(matrix)), values_(matrix_.rows()) {
  out_.precision(15);
  out_ << 't';
  for (const auto& probe : probes)
    for (const auto* component : {"_ux", "_uy", "_uz"}) out_ << ',' << probe.name << component;
  out_ << '\n';
}

void ProbeWriter::row(double t, Eigen::Ref<const Eigen::VectorXd> z) {
  values_.noalias() = matrix_ * z;
  out_ << t;
  for (const double value : values_) out_ << ',' << value;
  out_ << '\n';
}

void ProbeWriter::commit() {
  out_.close();
  if (!out_) throw std::runtime_error("could not write all of " + file_.path().string() + ": is the disk full?");
  file_.commit();
}

}  // namespace ritz::tools
