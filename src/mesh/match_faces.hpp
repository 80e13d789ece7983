// Which faces of a mesh's cells lie on each other. Serial, as topology.hpp is.
#pragma once
#include <unordered_map>
#include <vector>

#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

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
