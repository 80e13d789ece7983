// One rank's part of a mesh by file positions, before local numbers exist: made by the generator of boxes, or by
// deciding which rank gets which cell and distributing the mesh from rank 0.
#pragma once
#include <mpi.h>

#include <array>
#include <vector>

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

enum class Partitioner { metis, ptscotch };

/// *Collective*. Distributes the mesh of rank 0 (the argument of the other ranks is ignored) and returns the part of
/// this rank.
std::pair<Part, Shared> distribute(MPI_Comm comm, const FileMesh& mesh, Partitioner partitioner);

/// Removes the vertices that no cell uses from the mesh and from its sets; returns their number.
Index drop_unused_vertices(FileMesh& mesh);

/// The rank of each cell, by METIS (serial, k-way) from the pairs of cells that share a face. Some ranks may get no
/// cells.
std::vector<std::int32_t> partition_metis(Index cells, const std::vector<std::array<Index, 2>>& neighbours, int ranks);

/// *Collective*. The same by PT-Scotch on all ranks; rank 0 passes the graph and gets the result.
std::vector<std::int32_t> partition_ptscotch(MPI_Comm comm, Index cells,
                                             const std::vector<std::array<Index, 2>>& neighbours);

}  // namespace ritz::mesh
