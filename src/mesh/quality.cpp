#include "ritz/mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::mesh {
namespace {

/// What the determinant of a cell's Jacobian says of it.
enum class Fold : std::int32_t {
  none,
  corner,  ///< positive wherever the cell is integrated, not at a corner: its mid-edge vertices bend it there
  middle,  ///< integrals mean nothing, though its corners alone are a good cell
  whole    ///< inverted or flat
};

Fold fold_of(const Mesh& mesh, int cell) {
  const auto type = mesh.cells.types[static_cast<std::size_t>(cell)];
  const auto shape = fem::shape(type);
  const fem::CellVectors x = mesh.corners(cell);
  const bool corners = fem::smallest_jacobian(type, x) > 0;
  if (!shape.quadratic()) return corners ? Fold::none : Fold::whole;
  if (corners && fem::straight(type, x)) return Fold::none;
  if (fem::smallest_integrated_jacobian(type, x) > 0) return corners ? Fold::none : Fold::corner;
  return fem::smallest_jacobian(shape.linear, x.leftCols(shape.corners)) > 0 ? Fold::middle : Fold::whole;
}

double dihedral_of(const Mesh& mesh, int cell) {
  const auto type = mesh.cells.types[static_cast<std::size_t>(cell)];
  return fem::shape(type).corners == 4 ? fem::smallest_dihedral(mesh.corners(cell)) : 180;
}

/// Cells that share a fault, on all ranks.
struct Found {
  Index count = 0;
  std::vector<std::pair<Index, Index>> first;  ///< position in the file and the file's number of the first few
};

/// The owned cells that `is` holds for. *Collective*.
template <class Is>
Found find_cells(const Mesh& mesh, Is is) {
  constexpr std::size_t most = 5;
  std::vector<std::pair<Index, Index>> here;
  for (int c = 0; c < mesh.cells.owned; ++c)
    if (is(c))
      here.emplace_back(mesh.cells.numbers[static_cast<std::size_t>(c)], mesh.cells.ids[static_cast<std::size_t>(c)]);
  Found found{.count = parallel::sum(mesh.comm, static_cast<Index>(here.size())), .first = {}};
  std::sort(here.begin(), here.end());
  here.resize(std::min(here.size(), most));
  std::vector<Index> flat;
  for (const auto& [number, id] : here) flat.insert(flat.end(), {number, id});
  flat = parallel::gather_all(mesh.comm, flat);
  for (std::size_t i = 0; i < flat.size(); i += 2) found.first.emplace_back(flat[i], flat[i + 1]);
  std::sort(found.first.begin(), found.first.end());
  found.first.resize(std::min(found.first.size(), most));
  return found;
}

/// "1 cell (15)", "7 cells (15, 16, 17, 18, 19, ...)".
std::string named(const Found& found) {
  std::string text = counted(found.count, "cell", "cells") + " (";
  for (const auto& cell : found.first) text += std::to_string(cell.second) + ", ";
  if (found.count > std::ssize(found.first)) text += "...";
  else text.resize(text.size() - 2);
  return text + ")";
}

void add_bent_cells(const Mesh& mesh, std::vector<std::string>& notes) {
  const auto bent = find_cells(mesh, [&](int c) { return fold_of(mesh, c) == Fold::corner; });
  if (bent.count > 0)
    notes.push_back("mid-edge vertices stand so far from the middles of their edges that the Jacobian of " +
                    named(bent) +
                    " is not positive at a corner; it is wherever these are integrated, so they are "
                    "solved, but less exactly");
}

}  // namespace

void refuse_inverted_cells(const Mesh& mesh) {
  const auto bad = find_cells(mesh, [&](int c) { return fold_of(mesh, c) >= Fold::middle; });
  if (bad.count == 0) return;
  const auto folded = find_cells(mesh, [&](int c) { return fold_of(mesh, c) == Fold::middle; });
  const std::string cell = "cell " + std::to_string(bad.first[0].second) + " of the mesh is ";
  const std::string such = " (" + std::to_string(bad.count) + " such in all); ";
  if (folded.count > 0 && folded.first[0] == bad.first[0])
    throw InputError(cell + "folded by its mid-edge vertices, though its corners are in order" + such +
                     "move mid-edge vertices towards the middles of their edges, or mesh with straight edges");
  throw InputError(cell + "inverted or flat" + such + "repair the mesh, or reverse the order of its vertices");
}

std::vector<std::string> warnings(const Mesh& mesh) {
  auto notes = mesh.notes;
  add_bent_cells(mesh, notes);
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
                    " a quadratic cell to one without its mid-edge vertices: the mesh is not conforming there "
                    "(mid-edge vertices hang), and cells "
                    "come apart or overlap; use cells of one order");
  if (mesh.connected_parts > 1)
    notes.push_back("the mesh falls into " + std::to_string(mesh.connected_parts) + " disconnected pieces");
  else if (mesh.pieces > 1)
    notes.push_back("the mesh consists of " + std::to_string(mesh.pieces) +
                    " pieces that touch only in vertices or edges");
  return notes;
}

}  // namespace ritz::mesh
