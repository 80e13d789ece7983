// One rank's part of a mesh by file positions, before local numbers exist. Both the distribution of a file and the
// generator of boxes make it.
#pragma once
#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

struct PartSet {
  std::vector<Index> vertices;  ///< file positions of local vertices in the set
  std::vector<CellFace> faces;  ///< boundary faces of owned cells; filled where the file lists faces
  bool has_faces = false;       ///< the file lists faces, on any rank
};

struct PartSupport {
  std::vector<Index> vertices;
  std::array<bool, 3> held;  ///< along x, y, z
};

struct Part {
  /// Local vertices in ascending file position.
  std::vector<Index> positions, ids;
  std::vector<std::int32_t> owners, pieces;
  std::vector<double> points;  ///< 3 a vertex

  /// Local cells, owned ones first; their vertices by file position.
  Index owned_cells = 0;
  std::vector<fem::CellType> types;
  std::vector<Index> cell_vertices, numbers, cell_ids;
  std::vector<std::int32_t> regions;
  std::vector<CellFace> boundary;  ///< of owned cells
  std::vector<PartSet> sets;       ///< in the order of Shared::set_names
  std::vector<PartSupport> supports;
};

/// Data that is the same on all ranks.
struct Shared {
  Index vertices_total = 0, cells_total = 0, dropped_vertices = 0, hanging_faces = 0;
  std::vector<Region> regions;
  std::vector<std::string> set_names;
  int pieces = 1, connected_parts = 1;
  std::vector<Joint> joints;
  std::vector<std::string> notes;
};

/// *Collective*. Makes the mesh of this rank: owned vertices first, ghosts after them, global numbers from the owning
/// ranks.
Mesh number_part(MPI_Comm comm, Part part, Shared shared);

/// Sends a part to rank `to`, which calls receive_part.
void send_part(MPI_Comm comm, const Part& part, int to);
/// Receives the part that rank `from` sends.
Part receive_part(MPI_Comm comm, int from = 0);

/// *Collective*. Copies the value of rank 0 to all ranks.
void broadcast_shared(MPI_Comm comm, Shared& shared);

}  // namespace ritz::mesh
