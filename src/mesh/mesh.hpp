// The distributed mesh: each rank holds its own cells, a halo of cells, and the vertices of both.
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

// Types that the distributed mesh shares with the mesh file.
using readers::FaceCell;
using readers::FileMaterial;
using readers::FileMesh;
using readers::Ignored;
using readers::Index;
using readers::NamedSet;
using readers::Overlap;
using readers::Region;

/// Solid cells by local vertex numbers. The first `owned` belong to this rank. The rest is the halo: all other cells
/// that touch an owned vertex, so that rows of owned vertices can be summed completely without communication.
struct Cells {
  int owned = 0;
  std::vector<fem::CellType> types;
  std::vector<int> offsets = {0};
  std::vector<int> vertices;
  std::vector<std::int32_t> regions;
  std::vector<Index> numbers;   ///< position among all cells of the mesh, in the order of the file
  std::vector<Index> ids;       ///< the file's own number
  std::vector<int> file_order;  ///< all local cells, by ascending position

  int count() const { return static_cast<int>(types.size()); }
  std::span<const int> of(int cell) const {
    return std::span(vertices).subspan(static_cast<std::size_t>(offsets[static_cast<std::size_t>(cell)]),
                                       static_cast<std::size_t>(offsets[static_cast<std::size_t>(cell) + 1] -
                                                                offsets[static_cast<std::size_t>(cell)]));
  }
};

/// Face `face` (numbered as in fem::face_vertices) of local cell `cell`.
struct CellFace {
  int cell;
  int face;
  auto operator<=>(const CellFace&) const = default;
};

/// A named set, as this rank sees it. Name and totals are replicated.
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

/// A vertex in which several rigid pieces meet, so that they can hinge there.
struct Joint {
  std::array<double, 3> point;
  std::vector<int> pieces;  ///< numbers of all pieces; the first is the vertex's entry in Mesh::vertex_pieces
};

struct Mesh {
  MPI_Comm comm = MPI_COMM_NULL;
  Index vertices_total = 0;
  Index cells_total = 0;

  /// Local vertices: the first `owned`, by ascending file position; then the ghosts.
  int owned = 0;
  Index first = 0;                    ///< global number of the first owned vertex
  std::vector<Index> file_positions;  ///< position in the file, counting the vertices that cells use
  std::vector<Index> ids;             ///< the file's own numbers
  std::vector<Index> global;          ///< global numbers; those that a rank owns are contiguous
  Eigen::Matrix3Xd points;            ///< m
  std::vector<int> vertex_pieces;     ///< one of the pieces that the vertex belongs to; see joints
  Halo halo;                          ///< the exchange of values at ghosts

  Cells cells;
  std::vector<CellFace> boundary;  ///< boundary faces of owned cells
  std::vector<Region> regions;     ///< their materials in SI units
  std::vector<Set> sets;
  std::vector<Support> supports;             ///< those that the file gives
  std::vector<std::string> notes;            ///< warnings about the file, one sentence each
  std::vector<std::filesystem::path> files;  ///< on rank 0: all files that were read

  int pieces = 0;           ///< parts connected through faces: the rigid bodies of a mechanism
  int connected_parts = 0;  ///< parts connected through faces, edges or vertices
  std::vector<Joint> joints;
  Index dropped_vertices = 0;  ///< vertices of the file that no cell uses
  Index hanging_faces = 0;     ///< faces with mid-edge vertices that the cell on the other side lacks
  std::uint64_t checksum = 0;  ///< of vertices, cells and regions; the same on any number of ranks

  int local_vertices() const { return static_cast<int>(file_positions.size()); }
  Eigen::Matrix<double, 3, Eigen::Dynamic> corners(int cell) const;

  const Set* find(const std::string& name) const;
};

/// The local vertex numbers of a face, in the order of fem::face_vertices.
std::vector<int> face_vertices(const Mesh& mesh, CellFace face);

/// A box [low, high] of coordinates, m.
struct Region3 {
  Eigen::Vector3d low, high;

  Eigen::Vector3d middle() const { return (low + high) / 2; }
  Eigen::Vector3d size() const { return high - low; }
};

/// The smallest box that holds all vertices, to the last bit the same on any number of ranks. *Collective*.
Region3 bounding_box(const Mesh& mesh);

}  // namespace ritz::mesh
