// The distributed mesh: each rank holds its own cells, a halo of cells, and the vertices they need.
#pragma once
#include <mpi.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/mesh/halo.hpp"
#include "ritz/readers/file_mesh.hpp"

namespace ritz::mesh {

// What a distributed mesh has in common with its file.
using readers::FaceCell;
using readers::FileMaterial;
using readers::FileMesh;
using readers::Ignored;
using readers::Index;
using readers::NamedSet;
using readers::Overlap;
using readers::Region;

/// Solid cells by local vertex numbers. The first `owned` belong to this rank; the rest is the halo: every other cell
/// that touches an owned vertex, so that rows of owned vertices are complete without communication.
struct Cells {
  int owned = 0;
  std::vector<fem::CellType> types;
  std::vector<int> offsets = {0};
  std::vector<int> vertices;
  std::vector<std::int32_t> regions;
  std::vector<Index> numbers;   ///< position among all cells of the mesh, in the file's order
  std::vector<Index> ids;       ///< the file's own number
  std::vector<int> file_order;  ///< all of them, by ascending position

  int count() const { return static_cast<int>(types.size()); }
  std::span<const int> of(int cell) const {
    return std::span(vertices).subspan(static_cast<std::size_t>(offsets[static_cast<std::size_t>(cell)]),
                                       static_cast<std::size_t>(offsets[static_cast<std::size_t>(cell) + 1] -
                                                                offsets[static_cast<std::size_t>(cell)]));
  }
};

/// Face `face` (numbered as fem::face_vertices does) of local cell `cell`.
struct CellFace {
  int cell;
  int face;
  auto operator<=>(const CellFace&) const = default;
};

/// A named set on this rank. Replicated: name, totals.
struct Set {
  std::string name;
  std::vector<int> vertices;    ///< local numbers, owned and ghost, ascending
  std::vector<CellFace> faces;  ///< boundary faces of owned cells
  Index vertices_total = 0;
  Index faces_total = 0;
};

struct Support {
  std::vector<int> vertices;  ///< local numbers
  std::array<bool, 3> held;   ///< along x, y, z
};

/// A vertex where several rigid pieces meet: the body can hinge there.
struct Joint {
  std::array<double, 3> point;
  std::vector<int> pieces;  ///< all of them; the first is the vertex's in Mesh::vertex_pieces
};

struct Mesh {
  MPI_Comm comm = MPI_COMM_NULL;
  Index vertices_total = 0;
  Index cells_total = 0;

  /// Local vertices: the `owned` first, by ascending file position; then ghosts.
  int owned = 0;
  Index first = 0;                    ///< global number of the first owned vertex
  std::vector<Index> file_positions;  ///< row in the file's order, among vertices that cells use
  std::vector<Index> ids;             ///< the file's own numbers
  std::vector<Index> global;          ///< global number: owned ones contiguous by rank
  Eigen::Matrix3Xd points;            ///< m
  std::vector<int> vertex_pieces;     ///< a piece that the vertex belongs to; see joints
  Halo halo;                          ///< how ghosts get their values

  Cells cells;
  std::vector<CellFace> boundary;  ///< boundary faces of owned cells
  std::vector<Region> regions;     ///< materials in SI
  std::vector<Set> sets;
  std::vector<Support> supports;             ///< those that the file states
  std::vector<std::string> notes;            ///< what a careful user is told of the file
  std::vector<std::filesystem::path> files;  ///< rank 0: all that were read

  int pieces = 0;           ///< parts connected through faces: rigid bodies of a mechanism
  int connected_parts = 0;  ///< parts connected at all
  std::vector<Joint> joints;
  Index dropped_vertices = 0;  ///< in the file, in no cell
  Index hanging_faces = 0;     ///< of a Tet10 on a cell of straight edges, which its mid-edge vertices are no part of
  std::uint64_t checksum = 0;  ///< of vertices, cells and regions; the same on any number of ranks

  int local_vertices() const { return static_cast<int>(file_positions.size()); }
  Eigen::Matrix<double, 3, Eigen::Dynamic> corners(int cell) const;

  const Set* find(const std::string& name) const;
};

/// A face's local vertex numbers, in the order of fem::face_vertices.
std::vector<int> face_vertices(const Mesh& mesh, CellFace face);

}  // namespace ritz::mesh
