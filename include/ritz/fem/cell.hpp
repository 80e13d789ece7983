// The types of cells and faces: their vertices, edges and faces.
//
// Corners come first, then mid-edge vertices in the order of `edges`. The order of both is VTK's, and Abaqus's except
// that a wedge's triangles change places: here 012 is counter-clockwise seen from outside, as VTK documents it, and a
// wedge's volume is positive for (x1-x0) x (x2-x0) . (x3-x0) < 0, a tetrahedron's for > 0. Faces are numbered as Abaqus
// numbers them.
//
// A new cell type is an entry of CellType, a row here, and its shape functions and quadrature rules in
// src/fem/elements.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace ritz::fem {

enum class CellType : std::uint8_t { tet4, tet10, hex8, hex20, wedge6, wedge15, pyramid5 };
enum class FaceType : std::uint8_t { tri3, tri6, quad4, quad8 };

inline constexpr std::array cell_types = {CellType::tet4,   CellType::tet10,   CellType::hex8,    CellType::hex20,
                                          CellType::wedge6, CellType::wedge15, CellType::pyramid5};
inline constexpr std::array face_types = {FaceType::tri3, FaceType::tri6, FaceType::quad4, FaceType::quad8};

inline constexpr int max_cell_vertices = 20;
inline constexpr int max_face_vertices = 8;

struct FaceShape {
  std::string_view name;
  int vertices;
  int corners;
  int vtk;   ///< VTK's number of this cell type
  int gmsh;  ///< Gmsh's
  int xdmf;  ///< XDMF's
};

constexpr FaceShape shape(FaceType type) {
  switch (type) {
    case FaceType::tri3: return {"tri3", 3, 3, 5, 2, 0x4};
    case FaceType::tri6: return {"tri6", 6, 3, 22, 9, 0x24};
    case FaceType::quad4: return {"quad4", 4, 4, 9, 3, 0x5};
    case FaceType::quad8: return {"quad8", 8, 4, 23, 16, 0x25};
  }
  return {};
}

/// Two corners of a cell that an edge joins.
using Edge = std::array<int, 2>;

/// A face of a cell: its local vertex numbers, counter-clockwise seen from outside the cell; of a quadratic face the
/// corners, then the mid-edge vertices 01, 12, … of the face.
struct CellSide {
  FaceType type;
  std::array<int, max_face_vertices> numbers;

  constexpr std::span<const int> vertices() const {
    return std::span(numbers).first(static_cast<std::size_t>(shape(type).vertices));
  }
  constexpr std::span<const int> corners() const {
    return std::span(numbers).first(static_cast<std::size_t>(shape(type).corners));
  }
};

struct CellShape {
  std::string_view name;
  int vertices;                 ///< all of them, mid-edge ones too
  int corners;                  ///< vertices 0 ... corners-1 are the corners
  CellType linear;              ///< the type of the cell that the corners alone form
  int vtk;                      ///< VTK's number of this cell type
  int gmsh;                     ///< Gmsh's
  int xdmf;                     ///< XDMF's
  std::span<const Edge> edges;  ///< mid-edge vertex `corners` + e lies on edge e
  std::span<const CellSide> faces;

  constexpr bool quadratic() const { return vertices > corners; }
};

namespace detail {

inline constexpr std::array<Edge, 6> tet_edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
inline constexpr std::array<Edge, 12> hex_edges = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
inline constexpr std::array<Edge, 9> wedge_edges = {
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
inline constexpr std::array<Edge, 8> pyramid_edges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

constexpr CellSide triangle(int a, int b, int c) { return {FaceType::tri3, {a, b, c}}; }
constexpr CellSide quadrilateral(int a, int b, int c, int d) { return {FaceType::quad4, {a, b, c, d}}; }

inline constexpr std::array tet4_faces = {triangle(0, 2, 1), triangle(0, 1, 3), triangle(1, 2, 3), triangle(0, 3, 2)};
inline constexpr std::array hex8_faces = {quadrilateral(0, 3, 2, 1), quadrilateral(4, 5, 6, 7),
                                          quadrilateral(0, 1, 5, 4), quadrilateral(1, 2, 6, 5),
                                          quadrilateral(2, 3, 7, 6), quadrilateral(3, 0, 4, 7)};
inline constexpr std::array wedge6_faces = {triangle(3, 5, 4), triangle(0, 1, 2), quadrilateral(3, 4, 1, 0),
                                            quadrilateral(4, 5, 2, 1), quadrilateral(5, 3, 0, 2)};
inline constexpr std::array pyramid5_faces = {quadrilateral(0, 3, 2, 1), triangle(0, 1, 4), triangle(1, 2, 4),
                                              triangle(2, 3, 4), triangle(3, 0, 4)};

/// The faces of a linear cell with the mid-edge vertices of the quadratic one.
template <std::size_t faces, std::size_t edges>
constexpr std::array<CellSide, faces> with_middles(const std::array<CellSide, faces>& linear,
                                                   const std::array<Edge, edges>& all, int corners) {
  std::array<CellSide, faces> result = linear;
  for (std::size_t f = 0; f < faces; ++f) {
    const auto around = linear[f].corners();
    result[f].type = around.size() == 3 ? FaceType::tri6 : FaceType::quad8;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const int from = around[i], to = around[(i + 1) % around.size()];
      for (std::size_t e = 0; e < edges; ++e)
        if (all[e] == Edge{from, to} || all[e] == Edge{to, from})
          result[f].numbers[around.size() + i] = corners + static_cast<int>(e);
    }
  }
  return result;
}

inline constexpr auto tet10_faces = with_middles(tet4_faces, tet_edges, 4);
inline constexpr auto hex20_faces = with_middles(hex8_faces, hex_edges, 8);
inline constexpr auto wedge15_faces = with_middles(wedge6_faces, wedge_edges, 6);

}  // namespace detail

constexpr CellShape shape(CellType type) {
  switch (type) {
    case CellType::tet4: return {"tet4", 4, 4, CellType::tet4, 10, 4, 0x6, detail::tet_edges, detail::tet4_faces};
    case CellType::tet10: return {"tet10", 10, 4, CellType::tet4, 24, 11, 0x26, detail::tet_edges, detail::tet10_faces};
    case CellType::hex8: return {"hex8", 8, 8, CellType::hex8, 12, 5, 0x9, detail::hex_edges, detail::hex8_faces};
    case CellType::hex20: return {"hex20", 20, 8, CellType::hex8, 25, 17, 0x30, detail::hex_edges, detail::hex20_faces};
    case CellType::wedge6:
      return {"wedge6", 6, 6, CellType::wedge6, 13, 6, 0x8, detail::wedge_edges, detail::wedge6_faces};
    case CellType::wedge15:
      return {"wedge15", 15, 6, CellType::wedge6, 26, 18, 0x28, detail::wedge_edges, detail::wedge15_faces};
    case CellType::pyramid5:
      return {"pyramid5", 5, 5, CellType::pyramid5, 14, 7, 0x7, detail::pyramid_edges, detail::pyramid5_faces};
  }
  return {};
}

/// Face `face` of a cell, numbered from 0.
constexpr const CellSide& side(CellType type, int face) { return shape(type).faces[static_cast<std::size_t>(face)]; }

/// The local vertex numbers (0 ... vertices-1) of a face.
constexpr std::span<const int> face_vertices(CellType type, int face) { return side(type, face).vertices(); }

/// The type of cells or faces that VTK calls by a number; nothing if there is none.
constexpr std::optional<CellType> cell_of_vtk(int vtk) {
  for (const auto type : cell_types)
    if (shape(type).vtk == vtk) return type;
  return std::nullopt;
}
constexpr std::optional<FaceType> face_of_vtk(int vtk) {
  for (const auto type : face_types)
    if (shape(type).vtk == vtk) return type;
  return std::nullopt;
}

}  // namespace ritz::fem
