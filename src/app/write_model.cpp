#include "ritz/app/write_model.hpp"

#include <algorithm>

#include "ritz/app/checksums.hpp"
#include "ritz/app/frequencies.hpp"
#include "ritz/app/resolved.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/version.hpp"
#include "ritz/files/names.hpp"
#include "ritz/format/parallel_access.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

model::Provenance provenance(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy) {
  return {std::string("ritz-reduce ") + version, petsc::library_versions(), resolved(config, mesh, strategy),
          parallel::size(mesh.comm)};
}

model::Report report(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Results& results, const Progress& progress) {
  model::Report report;
  report.seconds = progress.seconds();
  report.notes = progress.warnings();
  report.figures = {{"vertices", static_cast<double>(mesh.vertices_total)},
                    {"cells", static_cast<double>(mesh.cells_total)},
                    {"degrees_of_freedom", static_cast<double>(dofs.total)},
                    {"pieces", static_cast<double>(mesh.pieces)},
                    {"dropped_vertices", static_cast<double>(mesh.dropped_vertices)},
                    {"eigensolver_iterations", static_cast<double>(results.modes.iterations)},
                    {"peak_memory_bytes", parallel::sum(mesh.comm, peak_memory())}};
  report.figures.insert(report.figures.end(), results.figures.begin(), results.figures.end());
  return report;
}

/// Column by column: all at once would be several copies of U, and more numbers than one message may have.
void write_columns(format::ModelWriter& out, MPI_Comm comm, const FileGeometry& order, const petsc::Tall& u) {
  const auto source = [&](format::Index column, std::span<double> values) {
    const parallel::RowMatrix rows = order.to_file(comm, by_vertex(u.col(column)));
    std::copy(rows.data(), rows.data() + rows.size(), values.begin());
  };
  format::write_basis(out, u.cols(), parallel::even_slice(comm, order.slices.vertices.total).count,
                      order.slices.vertices, source);
}

}  // namespace

void write_model(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                 const fem::Materials& materials, const FileGeometry& order, const Results& results,
                 const Progress& progress, const Outputs& outputs, std::vector<PendingFile>& exported) {
  const format::ParallelLists lists(mesh.comm);
  format::ModelWriter out(config.output, {lists.file.get(), lists.transfer.get(), parallel::rank(mesh.comm) == 0,
                                          [&](std::uint64_t mine) { return parallel::sum(mesh.comm, mine); },
                                          [&](bool yes) { return parallel::vote(mesh.comm, yes); }});
  format::write_provenance(out, provenance(config, mesh, results.modes.strategy));
  format::write_checksums(out, checksums(mesh, dofs, materials));
  format::write_geometry(out, order.geometry, order.slices);
  write_columns(out, mesh.comm, order, results.u);
  if (results.modes.modes.eigenvalues.size() > 0) format::write_modes(out, results.modes.modes);
  if (results.reduction) format::write_reduction(out, *results.reduction);
  if (results.polynomial) format::write_polynomial(out, *results.polynomial);
  format::write_inertia(out, results.inertia);
  format::write_loads(out, results.loads);
  format::write_report(out, report(mesh, dofs, results, progress));
  PendingFile table(mesh.comm, files::table_beside(config.output, "frequencies"));
  table.write(frequencies_csv(results.modes.modes));
  table.finish();
  out.finish();
  outputs.publish([&] {
    for (auto& file : exported) file.publish();
    table.publish();
    out.commit();
  });
}

}  // namespace ritz::app
