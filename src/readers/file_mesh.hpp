// A mesh as its file describes it, before it is distributed: the result of every reader.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/fem/cell.hpp"
#include "ritz/fem/material.hpp"

namespace ritz::readers {

using Index = std::int64_t;

/// The material of a region in the file, in the file's units. Options give what is absent.
struct FileMaterial {
  std::optional<double> young = {}, poisson = {}, density = {};
  /// The law where it is another than the default one. One of young and poisson is given by them, so that options may
  /// replace either.
  std::optional<fem::AnyLaw> law = {};
  /// Not empty if the file has an elastic law that ritz does not read: "FILE:LINE: material law X is not supported".
  /// This is no error if options give another law or its constants.
  std::string unread_law = {};
  /// The same for a density that ritz does not read, such as one that depends on temperature.
  std::string unread_density = {};
};

/// How the named parts of the body that share a region overlap: each lies inside the next, or they cross.
enum class Overlap : std::int8_t { nested, crossing };

/// A part of the mesh with one material: a physical volume of Gmsh, a region of Vega, a solid section of Abaqus. Where
/// physical volumes overlap, the cells of each combination are a region. Its name is that of the smallest volume if
/// each lies inside the next, that of the first if all have the same cells, else "A & B".
struct Region {
  std::string name;
  FileMaterial material = {};
  std::vector<std::string> parts = {};  ///< other names for its material: the larger volumes, ascending; or A and B
  Overlap overlap = Overlap::nested;    ///< crossing: none of `parts` takes precedence over another
};

/// A boundary face that the file lists (a cell of dimension 2): its vertices, corners first.
struct FaceCell {
  fem::FaceType type;
  std::array<Index, fem::max_face_vertices> vertices;
};

/// A named set of vertices; its name is "KIND:NAME" if the file has sets of several kinds with that name. A set of
/// cells (of any dimension) contains all their vertices, mid-edge ones too; a set of surface cells also keeps its
/// faces.
struct NamedSet {
  std::string name;
  std::vector<Index> vertices;  ///< positions in FileMesh::points, ascending, without duplicates
  std::vector<FaceCell> faces;
};

/// Fixed components of some vertices, as the file gives them (Abaqus *BOUNDARY).
struct FileSupport {
  std::vector<Index> vertices;
  std::array<bool, 3> held;  ///< along x, y, z
};

/// All vertex numbers here are positions in `points` (0-based, in the order of the file).
struct FileMesh {
  std::vector<std::array<double, 3>> points;  ///< in the file's units
  std::vector<Index> vertex_ids;              ///< the file's number of each vertex
  std::vector<fem::CellType> cell_types;      ///< solid cells only, in the order of the file
  std::vector<Index> cell_ids;                ///< the file's number of each cell
  std::vector<Index> cell_offsets = {0};      ///< cell c has cell_vertices[cell_offsets[c] ... cell_offsets[c+1])
  std::vector<Index> cell_vertices;           ///< in the order of fem/cell.hpp
  std::vector<std::int32_t> cell_regions;     ///< position in `regions`
  std::vector<Region> regions;
  std::vector<NamedSet> sets;
  std::vector<FileSupport> supports;
  std::vector<std::string> notes;            ///< warnings about the file: one sentence each, with file and line
  std::vector<std::filesystem::path> files;  ///< all files that were read: the mesh file and those it includes
};

/// What the user asks to ignore (-ignore): keywords, element types and sections of a file that change the physics and
/// that ritz does not support. In capitals and without blanks.
using Ignored = std::vector<std::string>;

/// The form in which words to be ignored are compared, "*Rigid body" -> "RIGIDBODY": in capitals, without blanks and
/// stars. Empty if nothing is left.
std::string ignored_word(std::string_view text);

/// Reads a mesh file, whose ending tells the format (.msh, .veg, .inp, .vtu). Serial. Throws InputError, naming file
/// and line (or the XML element), and no other exception.
FileMesh read_file(const std::filesystem::path& path, const Ignored& ignored = {});

/// The vertices of a Vega .bou file (numbered from 1 in the file) as positions from 0, ascending. Throws InputError for
/// a number outside 1 ... vertex_count.
std::vector<Index> read_bou(const std::filesystem::path& path, Index vertex_count);

}  // namespace ritz::readers
