// How the cells of a mesh file hang together. Serial: runs on the rank that read the file.
#pragma once
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

struct Topology {
  std::vector<std::array<Index, 2>> neighbours;  ///< pairs of cells that share a face
  std::vector<CellFace> boundary;                ///< faces of one cell only; ascending cell
  std::vector<std::vector<CellFace>> set_faces;  ///< of each FileMesh set that lists faces, those on the boundary
  std::vector<std::int32_t> vertex_pieces;       ///< a piece of each vertex
  std::vector<Joint> joints;
  int pieces = 0;           ///< parts connected through faces
  int connected_parts = 0;  ///< parts connected through vertices
  Index hanging_faces = 0;
};

/// Finds faces, pieces and joints. Throws InputError for a mesh of more than `max_pieces` pieces, for two cells of the
/// same corners, and for a face of three cells.
Topology find_topology(const FileMesh& mesh);

inline constexpr int max_pieces = 200;

}  // namespace ritz::mesh
