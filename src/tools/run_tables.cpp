#include "run_tables.hpp"

#include <cerrno>
#include <utility>

namespace ritz::tools {

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
    : table_(path), row_(3 * std::ssize(probes)) {
  table_.out() << 't';
  for (const auto& probe : probes)
    for (const auto* component : {"_ux", "_uy", "_uz"}) table_.out() << ',' << probe.name << component;
  table_.out() << '\n';
  for (auto& body : bodies) {
    Columns columns{.matrix = std::move(body.matrix), .probes = {}, .values = {}};
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (probes[i].body == body.name) columns.probes.push_back(static_cast<Eigen::Index>(i));
    columns.values.resize(columns.matrix.rows());
    bodies_.push_back(std::move(columns));
  }
}

void ProbeWriter::take(std::size_t body, double t, Eigen::Ref<const Eigen::VectorXd> z) {
  auto& columns = bodies_[body];
  columns.values.noalias() = columns.matrix * z;
  Eigen::Index from = 0;
  for (const auto probe : columns.probes) {
    row_.segment<3>(3 * probe) = columns.values.segment<3>(from);
    from += 3;
  }
  if (body + 1 < bodies_.size()) return;
  table_.out() << t;
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

}  // namespace ritz::tools
