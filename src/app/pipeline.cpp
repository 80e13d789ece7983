#include "ritz/app/pipeline.hpp"

#include "ritz/app/earlier.hpp"
#include "ritz/app/export.hpp"
#include "ritz/app/frequencies.hpp"
#include "ritz/app/full_start.hpp"
#include "ritz/app/geometry.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/plan.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/reduce.hpp"
#include "ritz/app/resources.hpp"
#include "ritz/app/static_path.hpp"
#include "ritz/app/warnings.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/base/counted.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/stages/inertia.hpp"
#include "ritz/stages/linear_cells.hpp"
#include "ritz/stages/set_loads.hpp"

namespace ritz::app {
namespace {

std::string size_line(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  return counted(mesh.vertices_total, "vertex", "vertices") + ", " + counted(mesh.cells_total, "cell", "cells") + ", " +
         counted(dofs.total, "degree of freedom", "degrees of freedom") + ", " +
         counted(std::ssize(mesh.sets), "named set", "named sets");
}

}  // namespace

void reduce(MPI_Comm comm, const config::Config& config) {
  Progress progress(comm, config.voice);
  if (config.goal == config::Goal::model) refuse_outputs(comm, config);
  const auto scene = config.accuracy ? std::optional(read_scene(comm, config.accuracy->scene)) : std::nullopt;
  const auto mesh = progress.stage("mesh", [&] { return mesh::read(comm, config.source); });
  const auto dofs = mesh::number(mesh, config.supports, config.file_supports);
  const auto materials = config::region_materials(config, mesh.regions);
  progress.line(size_line(mesh, dofs));
  for (const auto& text : warnings(mesh, materials)) progress.warn(text);

  const auto full = progress.stage("assemble", [&] { return stages::assemble(mesh, dofs, materials); });
  const auto options = choose_strategy(config, dofs);
  auto earlier = reuse(config, mesh, dofs, materials, options, progress);
  if (config.goal == config::Goal::plan) return print_plan(config, mesh, dofs, full, options, earlier, progress);
  const auto path = earlier.basis ? std::nullopt : static_path(config, scene, mesh, dofs, full, progress);
  const auto modes = earlier.basis ? earlier.basis->modes : progress.stage("modes", [&] {
    return stages::linear_modes(mesh, dofs, full, options, earlier.modes,
                                [&](const std::string& what, double fraction) { progress.update(what, fraction); });
  });
  for (const auto& text : modes.notes) progress.warn(text);
  if (!earlier.basis)
    for (const auto& text : stages::linear_cells_warning(mesh, dofs, materials, modes)) progress.warn(text);

  const auto reduced =
      earlier.basis ? std::move(earlier.basis->reduced) : reduce_basis(config, mesh, dofs, full, modes, path, progress);
  const auto u = mesh::to_vertices(mesh, dofs, reduced.U);
  const auto polynomial = reduce_forces(config, mesh, dofs, full, u, progress);
  const auto inertia = progress.stage("inertia", [&] { return stages::inertia(mesh, full.scalar_mass, u); });
  const auto loads = progress.stage("loads", [&] { return stages::set_loads(mesh, u); });
  if (config.exported != config::Export::nothing)
    progress.stage("export", [&] { export_matrices(config, mesh, dofs, full, modes.vectors); });

  progress.stage("write", [&] {
    const auto order = file_order(mesh, materials, config.rows);
    auto figures = reduced.figures;
    figures.insert(figures.end(), polynomial.witness.begin(), polynomial.witness.end());
    write_model(config, mesh, dofs, materials, order,
                {modes, u, reduced.reduction, polynomial.value, inertia, loads, figures}, progress);
  });
  const auto of_modes = stages::inertia(mesh, full.scalar_mass, mesh::to_vertices(mesh, dofs, modes.vectors));
  progress.line(summary(modes.modes, of_modes) + basis_lines(reduced, polynomial) + peak_memory_line(comm) +
                "\nwrote " + config.output.string());
}

}  // namespace ritz::app
