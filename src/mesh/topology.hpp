// How the cells of a mesh file hang together. Serial: runs on the rank that read the file.
#pragma once
#include <unordered_map>
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

/// A face by its corners, ascending; a triangle has a -1 before them.
using FaceKey = std::array<Index, 4>;

struct FaceKeyHash {
  std::size_t operator()(const FaceKey& key) const;
};

/// `corners`: three or four.
FaceKey face_key(std::span<const Index> corners);

struct MatchedFaces {
  std::vector<std::array<Index, 2>> neighbours;                 ///< pairs of cells that share a face
  std::unordered_map<FaceKey, CellFace, FaceKeyHash> boundary;  ///< faces of one cell only
  Index hanging = 0;                                            ///< pairs of which one has mid-edge vertices alone
};

/// Faces are shared by their corners; a quadrilateral also with the two triangles that a diagonal cuts it into. Throws
/// InputError naming the cells for two cells of the same corners and for three that share a face.
MatchedFaces match_faces(const FileMesh& mesh);

}  // namespace ritz::mesh
