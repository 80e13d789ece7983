// A mesh as a reader collects it, with cells of every dimension and the file's own numbers; and the checks of it.
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ritz/readers/file_mesh.hpp"
#include "ritz/readers/source.hpp"

namespace ritz::readers {

/// Maps numbers to their positions in a list. Numbers may be sparse and in any order; memory is proportional to the
/// list.
class IdMap {
 public:
  explicit IdMap(std::span<const Index> ids);

  /// The position of `id`, or -1.
  Index find(Index id) const;
  /// The position of a number that occurs earlier in the list as well.
  std::optional<Index> duplicate() const { return duplicate_; }
  /// The positions of those of the numbers first, first + step, ... <= last that are listed (0 <= first <= last, step >
  /// 0).
  std::vector<Index> range(Index first, Index last, Index step) const;
  /// The number of candidates that range() checks.
  std::uint64_t looked_at(Index first, Index last, Index step) const;

 private:
  Index first_ = 0;
  std::vector<Index> dense_;                     ///< position of the number first_ + i, or -1
  std::vector<std::pair<Index, Index>> sorted_;  ///< (number, position), if the numbers are too sparse for a table
  std::optional<Index> duplicate_;
};

/// What a file lists as a cell: a solid cell, or one of lower dimension, which only carries sets.
struct Shape {
  std::int8_t dimension;
  std::int8_t vertices;
  std::optional<fem::CellType> cell = {};  ///< dimension 3
  std::optional<fem::FaceType> face = {};  ///< dimension 2

  static constexpr Shape of(fem::CellType type) {
    return {3, static_cast<std::int8_t>(fem::shape(type).vertices), type, {}};
  }
  static constexpr Shape of(fem::FaceType type) {
    return {2, static_cast<std::int8_t>(fem::shape(type).vertices), {}, type};
  }
  bool operator==(const Shape&) const = default;
};

inline constexpr Shape point = {0, 1}, line2 = {1, 2}, line3 = {1, 3};

/// Face `face` of a listed solid cell, numbered as in fem/cell.hpp.
struct ListedFace {
  Index cell;
  int face;
};

/// The contents of a set. All numbers are positions in the ListedMesh.
struct ListedSet {
  std::string name;
  std::vector<Index> vertices;
  std::vector<Index> cells;
  std::vector<ListedFace> faces;
  std::string_view kind = {};  ///< a kind of base/set_name.hpp, if the format has sets of several kinds
};

/// The mesh. Cells refer to vertices by the file's own numbers; sets and supports by positions.
struct ListedMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<Index> vertex_ids;
  std::vector<Place> vertex_places;
  std::vector<Shape> shapes;
  std::vector<Index> cell_ids;
  std::vector<Place> cell_places;
  std::vector<Index> cell_offsets = {0};
  std::vector<Index> cell_vertices;
  std::vector<std::int32_t> cell_regions;  ///< position in `regions`, or -1
  std::vector<Region> regions;
  std::vector<ListedSet> sets;
  std::vector<FileSupport> supports;
  std::vector<std::string> notes;  ///< warnings about the file, one sentence each

  std::span<const Index> vertices_of(Index cell) const {
    const auto begin = cell_offsets[static_cast<std::size_t>(cell)];
    const auto end = cell_offsets[static_cast<std::size_t>(cell) + 1];
    return std::span(cell_vertices).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  }
};

void add_vertex(ListedMesh& mesh, Index id, const std::array<double, 3>& point, Place place);
/// Adds a cell, whose `vertices` are in the order of fem/cell.hpp.
void add_cell(ListedMesh& mesh, Shape shape, Index id, std::span<const Index> vertices, Place place);

/// Exchanges the triangles of a wedge, if `shape` is one: from the order of Gmsh and Abaqus to that of fem/cell.hpp.
void turn_wedge(Shape shape, std::span<Index> vertices);

/// Maps from the file's numbers to positions, for vertices and for cells.
struct Numbering {
  IdMap vertices;
  IdMap cells;
};

/// The maps of a mesh. Throws InputError when the file lists no vertices, or a number twice.
Numbering numbering(const Sources& sources, const ListedMesh& mesh);

/// Checks the mesh and returns it: every number is unique, every vertex of a cell exists and occurs once in it, and
/// there is at least one solid cell. Solid cells without a region get the region "default"; empty sets are left out.
/// Throws InputError.
FileMesh finish(const Sources& sources, ListedMesh mesh);

/// Returns `material` if it is possible (young > 0, -1 < poisson < 1/2, density > 0), else throws InputError at
/// `place`.
FileMaterial checked(const Sources& sources, Place place, const FileMaterial& material);

/// Returns `law` if its constants are possible and stable at rest, else throws InputError at `place`.
const fem::AnyLaw& possible(const Sources& sources, Place place, const fem::AnyLaw& law);

/// Handles something in the file that changes the physics and that ritz does not support. `word` (in capitals, without
/// blanks) is its name for -ignore; `what` says what it is and what ritz lacks ("*TIE joins surfaces, which ritz cannot
/// do"). Adds a note if `ignored` has the word, else throws an InputError at `place` that names -ignore.
void leave_out(const Sources& sources, Place place, const std::string& word, const std::string& what,
               const Ignored& ignored, ListedMesh& mesh);

/// Renames sets of several kinds that share a name to "KIND:NAME", with a note that says what the name alone means.
/// Throws InputError when another set has that name already.
void tell_kinds_apart(const Sources& sources, ListedMesh& mesh);

/// All sets that are not empty, as vertices and faces. `mesh.cell_vertices` must hold positions.
std::vector<NamedSet> gather_sets(const ListedMesh& mesh);

}  // namespace ritz::readers
