// How the cells of a mesh file are connected. Serial: runs on the rank that read the file.
#pragma once
#include <unordered_map>
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

struct Topology {
  std::vector<std::array<Index, 2>> neighbours;  ///< pairs of cells that share a face
  std::vector<CellFace> boundary;                ///< faces of one cell only, by ascending cell
  std::vector<std::vector<CellFace>> set_faces;  ///< for each set of the file that lists faces, those on the boundary
  std::vector<std::int32_t> vertex_pieces;       ///< one of the pieces that each vertex belongs to
  std::vector<Joint> joints;
  int pieces = 0;           ///< parts connected through faces
  int connected_parts = 0;  ///< parts connected through vertices
  Index hanging_faces = 0;
};

/// Finds faces, pieces and joints. Throws InputError for a mesh of more than `max_pieces` pieces, for two cells with
/// the same corners, and for a face of three cells.
Topology find_topology(const FileMesh& mesh);

inline constexpr int max_pieces = 200;

/// A face by its corners in ascending order; for a triangle the first entry is -1.
using FaceKey = std::array<Index, 4>;

struct FaceKeyHash {
  std::size_t operator()(const FaceKey& key) const;
};

/// `corners` has three or four entries.
FaceKey face_key(std::span<const Index> corners);

struct MatchedFaces {
  std::vector<std::array<Index, 2>> neighbours;                 ///< pairs of cells that share a face
  std::unordered_map<FaceKey, CellFace, FaceKeyHash> boundary;  ///< faces of one cell only
  Index hanging = 0;  ///< pairs in which a mid-edge vertex is one of one cell only
};

/// Two cells share a face if it has the same corners; a quadrilateral is also shared with the two triangles into which
/// a diagonal divides it. Throws an InputError that names the cells, when two have the same corners or three share a
/// face.
MatchedFaces match_faces(const FileMesh& mesh);

}  // namespace ritz::mesh
