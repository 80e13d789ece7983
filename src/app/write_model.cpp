#include "ritz/app/write_model.hpp"

#include <algorithm>

#include "ritz/app/frequencies.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/provenance.hpp"
#include "ritz/app/report.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/program.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/writer.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {

namespace {

model::Provenance provenance(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy) {
  return {std::string("ritz-reduce ") + version, algebra::library_versions(), resolved(config, mesh, strategy),
          parallel::size(mesh.comm)};
}

/// Column by column: all at once would be several copies of U, and more numbers than one message may have.
void write_columns(format::ModelWriter& out, const mesh::Mesh& mesh, const FileGeometry& order,
                   const Results& results) {
  const MPI_Comm comm = mesh.comm;
  const auto& u = results.u;
  const double diagonal = mesh::bounding_box(mesh).size().norm();
  std::vector<format::ShownColumn> columns;
  for (const auto& name : format::column_names(u.cols(), results.modes.modes, results.basis.reduction)) {
    const auto moved = by_vertex(u.col(static_cast<Eigen::Index>(columns.size())));
    const double mine = moved.rows() > 0 ? moved.rowwise().norm().maxCoeff() : 0;
    columns.push_back({name, format::factor_for_the_eye(parallel::max(comm, mine), diagonal)});
  }
  const auto source = [&](format::Index column, std::span<double> values) {
    const parallel::RowMatrix rows = order.to_file(comm, by_vertex(u.col(column)));
    std::copy(rows.data(), rows.data() + rows.size(), values.begin());
  };
  format::write_basis(out, columns, parallel::even_slice(comm, order.slices.vertices.total).count,
                      order.slices.vertices, source);
}

}  // namespace

struct WrittenModel::Files {
  explicit Files(MPI_Comm comm, const std::filesystem::path& path)
      : lists(comm),
        model(path, {lists.file.get(), lists.transfer.get(), parallel::rank(comm) == 0,
                     [comm](std::uint64_t mine) { return parallel::sum(comm, mine); },
                     [comm](bool yes) { return parallel::vote(comm, yes); }}),
        table(comm, files::table_beside(path, "frequencies")) {}

  format::ParallelLists lists;
  format::ModelWriter model;
  PendingFile table;
};

WrittenModel::WrittenModel(const config::Config& config, const stages::Problem& problem, const FileGeometry& order,
                           const Results& results, const Progress& progress)
    : files_(std::make_unique<Files>(problem.mesh.comm, config.output)) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  format::ModelWriter& out = files_->model;
  format::write_provenance(out, provenance(config, mesh, results.modes.strategy));
  format::write_checksums(out, checksums(mesh, dofs, materials));
  format::write_geometry(out, order.geometry, order.slices);
  write_columns(out, mesh, order, results);
  if (results.modes.modes.eigenvalues.size() > 0) format::write_modes(out, results.modes.modes);
  if (results.basis.reduction) format::write_reduction(out, *results.basis.reduction);
  if (const auto& polynomial = results.forces.polynomial) format::write_polynomial(out, polynomial->value);
  if (const auto& cubature = results.forces.cubature) format::write_cubature(out, *cubature);
  format::write_inertia(out, results.inertia);
  format::write_loads(out, results.loads);
  format::write_report(out, report(mesh, dofs, results, progress));
  files_->table.write(frequencies_csv(results.modes.modes, results.of_modes, results.mesh_errors));
  files_->table.finish();
  out.finish();
}

WrittenModel::~WrittenModel() = default;
WrittenModel::WrittenModel(WrittenModel&&) noexcept = default;

void WrittenModel::publish() {
  files_->table.publish();
  files_->model.commit();
}

}  // namespace ritz::app
