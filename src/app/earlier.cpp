#include "ritz/app/earlier.hpp"

#include "ritz/app/provenance.hpp"
#include "ritz/app/report.hpp"
#include "ritz/format/sound.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

/// What decides whether an earlier model fits.
struct Wanted {
  model::Checksums sums;
  Options options;
  config::Solver solver;
  config::Export exported;
  config::StaticErrors static_errors;
};

/// The options that a basis depends on, as they were given.
std::string made_with(const Options& options) {
  std::string text;
  for (const std::string name : {"modes", "modes_tolerance", "mesh_error", "basis_modes", "derivatives", "basis",
                                 "basis_tolerance", "snapshots", "residual_vectors", "accuracy", "accuracy_scene"})
    if (const auto value = value_of(options, name); !value.empty() && value != "false")
      text += (text.empty() ? "-" : " -") + name + " " + value;
  return text;
}

std::string obstacle_of_basis(const Options& then, const Wanted& now) {
  if (made_with(then) != made_with(now.options)) return "its basis was made with " + made_with(then);
  if (now.solver != config::Solver::automatic && value_of(then, "solver") != value_of(now.options, "solver"))
    return "it was made with -solver " + value_of(then, "solver");
  if (now.exported != config::Export::nothing) return "it stores the columns of a basis, not the modes to export";
  return "";
}

/// Why the model cannot be used; empty where it can.
std::string obstacle(const format::ModelReader& in, const Wanted& now) {
  const auto then = format::read_checksums(in);
  if (then.mesh != now.sums.mesh) return "it was made from another mesh";
  if (then.problem != now.sums.problem) return "its materials or supports are others";
  if (!format::read_modes(in) && !format::read_reduction(in)) return "it has no modes";
  if (format::read_geometry(in).rows != model::Rows::all) return "it stores the surface alone";
  if (!format::read_reduction(in)) return "";
  if (now.static_errors == config::StaticErrors::always && basis_figures(format::read_report(in)).static_errors.empty())
    return "it was made without -static_error";
  return obstacle_of_basis(format::read_provenance(in).options, now);
}

/// The rows of this rank's vertices of these columns.
algebra::Tall read_rows(const format::ModelReader& in, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                        std::optional<std::vector<format::Index>> columns) {
  format::BasisSelection selection;
  selection.columns = std::move(columns);
  selection.vertices.emplace(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const algebra::Tall u = format::read_basis(in, selection).U;
  return mesh::from_vertices(mesh, dofs, u);
}

std::vector<format::Index> flexible(const model::Modes& modes) {
  std::vector<format::Index> columns;
  for (std::size_t i = 0; i < modes.kinds.size(); ++i)
    if (modes.kinds[i] == model::ModeKind::flexible) columns.push_back(static_cast<format::Index>(i));
  return columns;
}

FinishedBasis read_finished(const format::ModelReader& in, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  FinishedBasis basis;
  const auto report = format::read_report(in);
  basis.modes.notes = report.notes;
  basis.mesh_errors = report.mesh_errors;
  basis.modes.modes = format::read_modes(in).value_or(model::Modes{});
  basis.modes.vectors.resize(dofs.owned, 0);
  basis.modes.strategy = value_of(format::read_provenance(in).options, "solver") == "iterative"
                             ? stages::Strategy::iterative
                             : stages::Strategy::direct;
  basis.modes.iterations = eigensolver_iterations(report);
  basis.reduced = {read_rows(in, mesh, dofs, {}), format::read_reduction(in), basis_figures(report)};
  return basis;
}

}  // namespace

Earlier reuse(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
              const fem::Materials& materials, const stages::ModesOptions& options, Progress& progress) {
  Earlier earlier{algebra::Tall(dofs.owned, 0), {}};
  if (!config.reuse) return earlier;
  const Wanted now{checksums(mesh, dofs, materials), resolved(config, mesh, options.strategy), config.solver,
                   config.exported, config.static_errors};
  std::string why_not;
  // checksums are of whole datasets, so one rank looks at all of it before all read their shares
  parallel::on_root(mesh.comm, [&] { format::check(format::ModelReader(*config.reuse)); });
  parallel::together(mesh.comm, [&] {
    const format::ModelReader in(*config.reuse);
    why_not = obstacle(in, now);
    if (!why_not.empty()) return;
    if (format::read_reduction(in)) earlier.basis = read_finished(in, mesh, dofs);
    else earlier.modes = read_rows(in, mesh, dofs, flexible(*format::read_modes(in)));
  });
  const std::string model = config.reuse->string();
  if (!why_not.empty()) progress.warn("nothing is reused of " + model + ": " + why_not);
  else if (earlier.basis)
    progress.line("reusing the basis of " + std::to_string(earlier.basis->reduced.U.cols()) + " columns of " + model);
  else progress.line("reusing " + std::to_string(earlier.modes.cols()) + " modes of " + model);
  return earlier;
}

}  // namespace ritz::app
