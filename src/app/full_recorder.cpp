#include "ritz/app/full_recorder.hpp"

#include <initializer_list>
#include <sstream>
#include <utility>

#include "ritz/app/full_start.hpp"
#include "ritz/files/part_file.hpp"

namespace ritz::app {

void FullTiming::begin_step() { begin_ = std::chrono::steady_clock::now(); }

void FullTiming::end_step(double t, const Effort& so_far) {
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin_;
  std::ostringstream row;
  row.precision(15);
  row << t << ',' << took.count() << ',' << so_far.iterations - before_.iterations << ','
      << so_far.rejected - before_.rejected << '\n';
  rows_ += row.str();
  before_ = so_far;
}

void FullTiming::finish() const {
  file_.write(rows_);
  file_.finish();
}

namespace {

std::string row(double t, const Eigen::VectorXd& values) {
  std::ostringstream out;
  out.precision(15);
  out << t;
  for (const double value : values) out << ',' << value;
  out << '\n';
  return out.str();
}

}  // namespace

FullRecorder::FullRecorder(const config::Config& config, const scene::Scene& scene, const stages::Problem& problem,
                           const FullPlan& plan, std::vector<std::int64_t> frame_states, Balanced acceleration)
    : mesh_(problem.mesh),
      dofs_(problem.dofs),
      probes_(scene, mesh_),
      acceleration_(std::move(acceleration)),
      file_(config.output, mesh_, problem.materials, plan),
      integrator_(integrator_name(scene)),
      kind_(std::holds_alternative<scene::Time>(scene.analysis) ? StateKind::moving : StateKind::at_rest),
      probe_rows_(probes_.header() + "\n"),
      energy_rows_("t,kinetic,elastic,work,dissipated,drift\n"),
      frame_states_(std::move(frame_states)) {
  const auto table = [&](const char* name) { return files::table_beside(config.output, name); };
  if (kind_ == StateKind::moving) energy_file_.emplace(mesh_.comm, table("energy"));
  if (!scene.probes.empty()) probe_file_.emplace(mesh_.comm, table("probes"));
  if (config.full.timing) timing_.emplace(mesh_.comm, *config.full.timing);
}

void FullRecorder::start(const stages::DynamicState& state) {
  record(state);
  if (timing_) timing_->begin_step();
}

void FullRecorder::step(const stages::DynamicState& state, const Effort& so_far) {
  if (timing_) timing_->end_step(state.t, so_far);
  record(state);
  if (timing_) timing_->begin_step();
}

void FullRecorder::record(const stages::DynamicState& state) {
  const algebra::Tall u = mesh::to_vertices(mesh_, dofs_, state.u);
  const auto& e = state.energies;
  Eigen::VectorXd energies(5);
  energies << e.kinetic, e.elastic, e.work, e.dissipated, e.drift();
  energy_rows_ += row(state.t, energies);
  if (probe_file_) {
    std::array<mesh::VertexRows, 3> moment = {u, {}, {}};
    if (probes_.any(scene::Quantity::velocity)) moment[1] = mesh::to_vertices(mesh_, dofs_, state.v);
    if (probes_.any(scene::Quantity::acceleration)) moment[2] = mesh::to_vertices(mesh_, dofs_, acceleration_(state));
    probe_rows_ += row(state.t, probes_.at(moment));
  }
  if (next_frame_ < frame_states_.size() && frame_states_[next_frame_] == state_) {
    file_.frame(u);
    ++next_frame_;
  }
  ++state_;
}

void FullRecorder::finish(const stages::DynamicState& last, const std::string& problem_checksum) {
  const auto& e = last.energies;
  const auto whole = [&](const algebra::Tall& x) { return mesh::to_vertices(mesh_, dofs_, x); };
  file_.keep({.kind = kind_,
              .integrator = integrator_,
              .numbers = {{"t", last.t},
                          {"kinetic", e.kinetic},
                          {"elastic", e.elastic},
                          {"work", e.work},
                          {"dissipated", e.dissipated},
                          {"start", e.start}},
              .u = whole(last.u),
              .v = whole(last.v),
              .a = whole(last.a)},
             problem_checksum);
  const auto write = [](PendingFile& file, const std::string& rows) {
    file.write(rows);
    file.finish();
  };
  if (energy_file_) write(*energy_file_, energy_rows_);
  if (probe_file_) write(*probe_file_, probe_rows_);
  if (timing_) timing_->finish();
  file_.finish();
}

void FullRecorder::publish() {
  if (energy_file_) energy_file_->publish();
  if (probe_file_) probe_file_->publish();
  if (timing_) timing_->publish();
  file_.publish();
}

}  // namespace ritz::app
