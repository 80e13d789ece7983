#include "ritz/app/warnings.hpp"

#include <algorithm>

#include "ritz/algebra/session.hpp"
#include "ritz/app/plausible.hpp"
#include "ritz/mesh/quality.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

constexpr double locking_poisson = 0.45;  ///< above it linear tetrahedra are visibly too stiff

/// Linear tetrahedra cannot change shape at constant volume: nearly incompressible, they lock.
bool locks(const mesh::Mesh& mesh, const fem::Materials& materials) {
  std::int32_t found = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (mesh.cells.types[i] == fem::CellType::tet4 &&
        materials[static_cast<std::size_t>(mesh.cells.regions[i])].at_rest().poisson() > locking_poisson)
      found = 1;
  }
  return parallel::max(mesh.comm, found) > 0;
}

bool free_by_default(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  return config.file_supports == mesh::FileSupports::used && dofs.total == mesh::components * mesh.vertices_total;
}

}  // namespace

std::vector<std::string> warnings(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const fem::Materials& materials) {
  auto notes = mesh::warnings(mesh);
  if (locks(mesh, materials))
    notes.push_back(
        "linear tetrahedra (tet4) lock at a Poisson's ratio above 0.45: frequencies come out too high; use tet10");
  const auto of_units = unit_warnings(extent(mesh, materials), mesh.regions, materials, config);
  notes.insert(notes.end(), of_units.begin(), of_units.end());
  if (free_by_default(config, mesh, dofs))
    notes.push_back(
        "nothing holds the body: there is no -fix, and the mesh states no supports; hold it with -fix SET, or say -fix "
        "none for a free body");
  if (!algebra::blas_is_openblas())
    notes.push_back(
        "the BLAS that is loaded is not OpenBLAS; with the reference BLAS factorizations take several times longer "
        "(Debian: libopenblas-dev)");
  return notes;
}

}  // namespace ritz::app
