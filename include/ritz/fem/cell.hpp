// Cell and face types, and the order of their vertices.
//
// The vertex order is VTK's (for tetrahedra also Abaqus's). Tet10 has its mid-edge vertices on the edges 01, 12, 20,
// 03, 13, 23. Hex8 has the bottom face 0123, counter-clockwise seen from above, then the top face 4567. A right-handed
// cell has a positive volume: (x1-x0) x (x2-x0) . (x3-x0) > 0 for a tetrahedron.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace ritz::fem {

enum class CellType : std::uint8_t { tet4, tet10, hex8 };
enum class FaceType : std::uint8_t { tri3, tri6, quad4 };

struct CellShape {
  std::string_view name;
  int dimension;
  int vertices;  ///< all of them, mid-edge ones too
  int corners;   ///< vertices 0 ... corners-1 are the corners
  int faces;
  FaceType face;
  int vtk;  ///< VTK's number of this cell type
};

struct FaceShape {
  std::string_view name;
  int vertices;
  int corners;
  int vtk;
};

constexpr CellShape shape(CellType type) {
  switch (type) {
    case CellType::tet4: return {"tet4", 3, 4, 4, 4, FaceType::tri3, 10};
    case CellType::tet10: return {"tet10", 3, 10, 4, 4, FaceType::tri6, 24};
    case CellType::hex8: return {"hex8", 3, 8, 8, 6, FaceType::quad4, 12};
  }
  return {};
}

constexpr FaceShape shape(FaceType type) {
  switch (type) {
    case FaceType::tri3: return {"tri3", 3, 3, 5};
    case FaceType::tri6: return {"tri6", 6, 3, 22};
    case FaceType::quad4: return {"quad4", 4, 4, 9};
  }
  return {};
}

inline constexpr int max_cell_vertices = 10;
inline constexpr int max_face_vertices = 6;

namespace detail {
inline constexpr std::array<std::array<int, 6>, 4> tet_faces = {
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};
inline constexpr std::array<std::array<int, 4>, 6> hex_faces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}  // namespace detail

/// The local vertex numbers (0 ... vertices-1) of face `face` of a cell, counter-clockwise seen from outside the cell;
/// for tri6 the three corners, then the mid-edge vertices 01, 12, 20 of the face.
constexpr std::span<const int> face_vertices(CellType type, int face) {
  const auto f = static_cast<std::size_t>(face);
  switch (type) {
    case CellType::tet4: return std::span<const int>(detail::tet_faces[f]).first(3);
    case CellType::tet10: return detail::tet_faces[f];
    case CellType::hex8: return detail::hex_faces[f];
  }
  return {};
}

}  // namespace ritz::fem
