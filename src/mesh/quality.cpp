#include "ritz/mesh/quality.hpp"

#include <cmath>
#include <limits>

#include "ritz/base/counted.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::mesh {
namespace {

double jacobian_of(const Mesh& mesh, int cell) {
  return fem::visit(mesh.cells.types[static_cast<std::size_t>(cell)],
                    [&]<class E>(E) { return fem::smallest_jacobian<E>(fem::Coordinates<E>(mesh.corners(cell))); });
}

double dihedral_of(const Mesh& mesh, int cell) {
  const auto type = mesh.cells.types[static_cast<std::size_t>(cell)];
  if (fem::shape(type).corners != 4) return 180;
  return fem::smallest_dihedral<fem::Tet4>(fem::Coordinates<fem::Tet4>(mesh.corners(cell).leftCols<4>()));
}

/// The file's number of the first cell (in the file's order) among those that ranks hold, one candidate a rank.
Index first_id(const Mesh& mesh, Index number, Index id) {
  const Index first = parallel::min(mesh.comm, number);
  return parallel::max(mesh.comm, number == first ? id : std::numeric_limits<Index>::min());
}

}  // namespace

void refuse_inverted_cells(const Mesh& mesh) {
  Index bad = 0, number = std::numeric_limits<Index>::max(), id = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    if (jacobian_of(mesh, c) > 0) continue;
    ++bad;
    const auto i = static_cast<std::size_t>(c);
    if (mesh.cells.numbers[i] < number) {
      number = mesh.cells.numbers[i];
      id = mesh.cells.ids[i];
    }
  }
  bad = parallel::sum(mesh.comm, bad);
  if (bad == 0) return;
  throw InputError("cell " + std::to_string(first_id(mesh, number, id)) + " of the mesh is inverted or flat (" +
                   std::to_string(bad) + " such in all); repair the mesh, or reverse the order of its vertices");
}

std::vector<std::string> warnings(const Mesh& mesh) {
  auto notes = mesh.notes;
  Index slivers = 0;
  double smallest = 180;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const double angle = dihedral_of(mesh, c);
    slivers += angle < 1;
    smallest = std::min(smallest, angle);
  }
  slivers = parallel::sum(mesh.comm, slivers);
  smallest = parallel::min(mesh.comm, smallest);
  if (slivers > 0)
    notes.push_back(counted(slivers, "cell has", "cells have") + " a dihedral angle under 1 degree (the smallest " +
                    shown(smallest, 3) + "); the conditioning suffers");
  if (mesh.dropped_vertices > 0)
    notes.push_back(counted(mesh.dropped_vertices, "vertex that no cell uses was", "vertices that no cell uses were") +
                    " dropped");
  if (mesh.hanging_faces > 0)
    notes.push_back(counted(mesh.hanging_faces, "face joins", "faces join") +
                    " a tet10 to a tet4 or hex8: the mesh is not conforming there (mid-edge vertices hang), and cells "
                    "come apart or overlap; use cells of one order");
  if (mesh.components > 1)
    notes.push_back("the mesh falls into " + std::to_string(mesh.components) + " disconnected pieces");
  else if (mesh.pieces > 1)
    notes.push_back("the mesh consists of " + std::to_string(mesh.pieces) +
                    " pieces that touch only in vertices or edges");
  return notes;
}

}  // namespace ritz::mesh
