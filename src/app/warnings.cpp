#include "ritz/app/warnings.hpp"

#include <algorithm>

#include "ritz/mesh/quality.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/session.hpp"

namespace ritz::app {
namespace {

constexpr double locking_poisson = 0.45;  ///< above it linear tetrahedra are visibly too stiff

/// Linear tetrahedra cannot change shape at constant volume: nearly incompressible, they lock.
bool locks(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials) {
  std::int32_t found = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (mesh.cells.types[i] == fem::CellType::tet4 &&
        materials[static_cast<std::size_t>(mesh.cells.regions[i])].poisson > locking_poisson)
      found = 1;
  }
  return parallel::max(mesh.comm, found) > 0;
}

}  // namespace

std::vector<std::string> warnings(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials) {
  auto notes = mesh::warnings(mesh);
  if (locks(mesh, materials))
    notes.push_back(
        "linear tetrahedra (tet4) lock at a Poisson's ratio above 0.45: frequencies come out too high; use tet10");
  if (!petsc::blas_is_openblas())
    notes.push_back(
        "the BLAS that is loaded is not OpenBLAS; with the reference BLAS factorizations take several times longer "
        "(Debian: libopenblas-dev)");
  return notes;
}

}  // namespace ritz::app
