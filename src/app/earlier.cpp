#include "ritz/app/earlier.hpp"

#include "ritz/app/checksums.hpp"
#include "ritz/format/contents.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

/// Checksums are of whole datasets, so one rank looks at them before all read their shares.
void verify_all(const std::filesystem::path& path) {
  const format::ModelReader in(path);
  for (const auto& dataset : format::contents(in)) format::verify(in, dataset);
}

/// Why the model cannot be used; empty where it can.
std::string obstacle(const format::ModelReader& in, const Checksums& now) {
  const auto then = format::read_provenance(in);
  if (then.mesh_checksum != now.mesh) return "it was made from another mesh";
  if (then.problem_checksum != now.problem) return "its materials or supports are others";
  if (format::read_reduction(in)) return "it stores the columns of a basis, not modes";
  if (!format::read_modes(in)) return "it has no modes";
  if (format::read_geometry(in).rows != model::Rows::all) return "it stores the surface alone";
  return "";
}

/// The rows of this rank's vertices of the flexible columns.
petsc::Tall read_rows(const format::ModelReader& in, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  const auto modes = *format::read_modes(in);
  format::BasisSelection selection;
  selection.columns.emplace();
  for (std::size_t i = 0; i < modes.kinds.size(); ++i)
    if (modes.kinds[i] == model::ModeKind::flexible) selection.columns->push_back(static_cast<format::Index>(i));
  selection.vertices.emplace(mesh.file_positions.begin(), mesh.file_positions.begin() + mesh.owned);
  const petsc::Tall u = format::read_basis(in, selection).U;
  return mesh::from_vertices(mesh, dofs, u);
}

}  // namespace

petsc::Tall modes_to_reuse(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                           const std::vector<fem::StVK>& materials, Progress& progress) {
  petsc::Tall known(dofs.owned, 0);
  if (!config.reuse) return known;
  const Checksums now = checksums(mesh, dofs, materials);
  std::string why_not;
  parallel::on_root(mesh.comm, [&] { verify_all(*config.reuse); });
  parallel::together(mesh.comm, [&] {
    const format::ModelReader in(*config.reuse);
    why_not = obstacle(in, now);
    if (why_not.empty()) known = read_rows(in, mesh, dofs);
  });
  if (why_not.empty()) progress.line("reusing " + std::to_string(known.cols()) + " modes of " + config.reuse->string());
  else progress.warn("nothing is reused of " + config.reuse->string() + ": " + why_not);
  return known;
}

}  // namespace ritz::app
