#include "ritz/app/program.hpp"

#include <algorithm>

#include "ritz/app/earlier.hpp"
#include "ritz/app/export.hpp"
#include "ritz/app/file_geometry.hpp"
#include "ritz/app/frequencies.hpp"
#include "ritz/app/full_start.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/app/snapshots.hpp"
#include "ritz/app/static_loads.hpp"
#include "ritz/app/summary.hpp"
#include "ritz/app/warnings.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/stages/linear_cells.hpp"
#include "ritz/stages/mesh_error.hpp"
#include "ritz/stages/projection.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::app {
namespace {

std::string mesh_line(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  return counted(mesh.vertices_total, "vertex", "vertices") + ", " + counted(mesh.cells_total, "cell", "cells") + ", " +
         counted(dofs.total, "degree of freedom", "degrees of freedom") + ", " +
         counted(std::ssize(mesh.sets), "named set", "named sets");
}

void refuse_an_empty_model(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  const bool nothing_asked = config.modes.count == 0 && !config.basis && !config.residual_vectors &&
                             config.exported == config::Export::nothing;
  if (nothing_asked && stages::rigid_motions(mesh, dofs).cols() == 0)
    throw InputError(
        "option -modes 0: the body is held, so it has no rigid modes either, and the model would be empty; raise "
        "-modes, or give -snapshots, whose basis needs none");
}

void refuse_needless_cubature(const config::Config& config, const fem::Materials& materials) {
  if (config.forces == config::ReducedForces::cubature && fem::force_degree(materials))
    throw InputError(
        "option -cubature: the forces of all materials are polynomials (stvk or stvk-orthotropic), which -polynomial "
        "reduces exactly; give -polynomial in its place");
}

void refuse_unknown_mesh_errors(const config::Config& config, const mesh::Mesh& mesh) {
  if (config.mesh_errors == config::MeshErrors::unknown) return;
  if (const auto obstacle = stages::mesh_error_obstacle(mesh); !obstacle.empty())
    throw InputError("option -mesh_error: " + obstacle + "; leave it out");
}

/// The estimated error of each mode, or a warning where none is asked for and linear cells are clearly too stiff.
Eigen::VectorXd mesh_errors(const config::Config& config, const stages::Problem& problem,
                            const stages::ModesResult& modes, Progress& progress) {
  if (config.mesh_errors == config::MeshErrors::estimated)
    return progress.stage("mesh error", [&] {
      return stages::mesh_errors(problem, modes,
                                 [&](const mesh::Dofs& dofs) { return choose_strategy(config, dofs).strategy; });
    });
  for (const auto& text : stages::linear_cells_warning(problem, modes)) progress.warn(text);
  return {};
}

/// The plan, printed and in the summary.
void foresee(const config::Config& config, const stages::Problem& problem, const stages::ModesOptions& options,
             const Earlier& earlier, const std::optional<Outputs>& outputs, const Progress& progress) {
  const MPI_Comm comm = problem.mesh.comm;
  const Plan plan = make_plan(config, problem, options, earlier, progress);
  auto summary = written_summary(comm, config, [&] { return plan_summary(config, problem, earlier, plan, progress); });
  if (summary) outputs->publish([&] { summary->publish(); });
  print_plan(comm, plan, progress);
}

}  // namespace

void reduce(MPI_Comm comm, const config::Config& config) {
  Progress progress(comm, config.voice);
  const bool plan_alone = config.goal == config::Goal::plan;
  const auto outputs = plan_alone ? claim_reports(comm, config) : claim_model(comm, config);
  for (const auto& text : config.warnings) progress.warn(text);
  const auto scene = config.accuracy ? std::optional(read_scene(comm, config.accuracy->scene)) : std::nullopt;
  auto body = progress.stage("mesh", [&] { return mesh::read(comm, config.source); });
  if (outputs) outputs->refuse_inputs(body.files);
  auto numbering = mesh::number(body, config.supports, config.file_supports);
  auto laws = config::region_materials(config, body.regions);
  progress.line(mesh_line(body, numbering));
  for (const auto& text : warnings(config, body, numbering, laws)) progress.warn(text);

  refuse_an_empty_model(config, body, numbering);
  refuse_unknown_mesh_errors(config, body);
  refuse_needless_cubature(config, laws);
  const auto residual = residual_places(config, body);
  const auto problem = progress.stage(
      "assemble", [&] { return stages::assemble(std::move(body), std::move(numbering), std::move(laws)); });
  const mesh::Mesh& mesh = problem.mesh;
  const mesh::Dofs& dofs = problem.dofs;
  const auto options = choose_strategy(config, dofs);
  auto earlier = reuse(config, mesh, dofs, problem.materials, options, progress);
  if (config.snapshots && !earlier.basis) count_snapshots(*config.snapshots, mesh);  // before the long work
  if (plan_alone) return foresee(config, problem, options, earlier, outputs, progress);
  const auto places =
      earlier.basis ? std::vector<stages::LoadPlace>() : answered_places(config, problem, options.strategy, residual);
  const StaticLoads static_loads{stages::unit_loads(problem, places), residual};
  const auto path = earlier.basis ? std::nullopt : static_path(config, scene, problem, progress);
  const auto modes = earlier.basis ? earlier.basis->modes : progress.stage("modes", [&] {
    return stages::linear_modes(problem, options, earlier.modes, static_loads.solved.columns,
                                [&](const std::string& what, double fraction) { progress.update(what, fraction); });
  });
  for (const auto& text : modes.notes) progress.warn(text);
  const auto errors = earlier.basis ? earlier.basis->mesh_errors : mesh_errors(config, problem, modes, progress);

  const auto reduced = earlier.basis ? std::move(earlier.basis->reduced)
                                     : reduce_basis(config, problem, modes, static_loads, path, progress);
  if (const auto rigid = std::ranges::count(modes.modes.kinds, model::ModeKind::rigid); config.basis && rigid > 0)
    progress.warn("the basis leaves out the body's " + counted(rigid, "rigid motion", "rigid motions") +
                  ": the model neither falls nor flies, and ritz-run refuses loads that would make it");
  const auto u = mesh::to_vertices(mesh, dofs, reduced.U);
  const auto forces = reduce_forces(config, problem, reduced, u, progress);
  const auto inertia =
      progress.stage("inertia", [&] { return stages::inertia(mesh, problem.matrices.scalar_mass, u); });
  const auto loads = progress.stage("loads", [&] { return stages::set_loads(mesh, u); });
  std::vector<PendingFile> exported;
  if (config.exported != config::Export::nothing)
    progress.stage("export", [&] { exported = export_matrices(config, problem, modes.vectors); });

  const auto of_modes =
      stages::inertia(mesh, problem.matrices.scalar_mass, mesh::to_vertices(mesh, dofs, modes.vectors));
  const Results results{modes, errors, u, reduced, forces, inertia, loads, of_modes};
  auto written = progress.stage("write", [&] {
    return WrittenModel(config, problem, file_geometry(mesh, problem.materials, config.rows), results, progress);
  });
  auto summary =
      written_summary(comm, config, [&] { return model_summary(config, problem, earlier, results, progress); });
  outputs->publish([&] {
    for (auto& file : exported) file.publish();
    if (summary) summary->publish();
    written.publish();
  });
  progress.line(size_line(extent(mesh, problem.materials), modes.modes) + "\n" +
                modes_lines(modes.modes, of_modes, errors, config.voice) +
                basis_lines(reduced, forces, inertia, config.voice) +
                static_error_lines(config, reduced.figures.static_errors, residual) + peak_memory_line(comm) + "\n" +
                outputs->replaced() + "wrote " + config.output.string());
}

}  // namespace ritz::app
