// A mesh as its file states it, before it is distributed: what every reader returns.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ritz/fem/cell.hpp"

namespace ritz::readers {

using Index = std::int64_t;

/// What a file says of a material, in the file's units. What it leaves open is for the options to say.
struct FileMaterial {
  std::optional<double> young = {}, poisson = {}, density = {};
  /// Where the file states an elastic law that ritz does not read: "FILE:LINE: material law X is not supported". The
  /// options get past it by stating young and poisson themselves. Empty otherwise.
  std::string unread_law = {};
  /// The same of a density that ritz does not read, such as one that depends on temperature.
  std::string unread_density = {};
};

/// How the named parts of a body that share a region lie in each other.
enum class Overlap : std::int8_t { nested, crossing };

/// A part of the mesh with one material: a Gmsh physical volume, a Vega region, an Abaqus solid section. Where physical
/// volumes overlap, the cells of each combination are a region: named by the smallest where each lies inside the next,
/// by the first where all have the same cells, else "A & B".
struct Region {
  std::string name;
  FileMaterial material = {};
  std::vector<std::string> parts = {};  ///< other names of its material: the larger ones, ascending; or A and B
  Overlap overlap = Overlap::nested;    ///< crossing: none of `parts` wins over another
};

/// A face of the boundary as the file lists it (a cell of dimension 2): its vertices, corners first.
struct FaceCell {
  fem::FaceType type;
  std::array<Index, fem::max_face_vertices> vertices;
};

/// A named set of vertices; "KIND:NAME" where the file has sets of several kinds with that name. A set of cells (of any
/// dimension) is the set of all their vertices, mid-edge ones too; a set of surface cells keeps its faces as well.
struct NamedSet {
  std::string name;
  std::vector<Index> vertices;  ///< positions in FileMesh::points, ascending, no doubles
  std::vector<FaceCell> faces;
};

/// Fixed components of some vertices, as the file itself states them (Abaqus *BOUNDARY).
struct FileSupport {
  std::vector<Index> vertices;
  std::array<bool, 3> held;  ///< along x, y, z
};

/// All vertex numbers here are positions in `points` (0-based, the file's own order).
struct FileMesh {
  std::vector<std::array<double, 3>> points;  ///< in the file's units
  std::vector<Index> vertex_ids;              ///< the file's own number of each vertex, one per point
  std::vector<fem::CellType> cell_types;      ///< solid cells only, in the file's order
  std::vector<Index> cell_ids;                ///< the file's own numbers
  std::vector<Index> cell_offsets = {0};      ///< cell c has cell_vertices[cell_offsets[c] ... cell_offsets[c+1])
  std::vector<Index> cell_vertices;           ///< in the order of fem/cell.hpp
  std::vector<std::int32_t> cell_regions;     ///< position in `regions`
  std::vector<Region> regions;
  std::vector<NamedSet> sets;
  std::vector<FileSupport> supports;
  std::vector<std::string> notes;  ///< what a careful user is told of the file: a sentence each, with file and line
  std::vector<std::filesystem::path> files;  ///< all that were read: the mesh file, and what it includes
};

/// Keywords, element types and sections of a file that change the physics, that ritz cannot do, and that the user says
/// to leave out (-ignore): in capitals and without blanks.
using Ignored = std::vector<std::string>;

/// Reads a mesh file; the ending tells the format (.msh, .veg, .inp, .vtu).
/// Serial. Throws InputError naming file and line (or the XML element), never anything else.
FileMesh read_file(const std::filesystem::path& path, const Ignored& ignored = {});

/// The vertices of a Vega .bou file (1-based numbers in the file), as positions 0-based, ascending.
/// Throws InputError for a number that is not in 1 ... vertex_count.
std::vector<Index> read_bou(const std::filesystem::path& path, Index vertex_count);

}  // namespace ritz::readers
