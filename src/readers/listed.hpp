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

enum class Shape : std::uint8_t { point, line2, line3, tri3, tri6, quad4, tet4, tet10, hex8 };

struct ShapeTraits {
  int dimension;
  int vertices;
  std::optional<fem::CellType> cell;  ///< dimension 3
  std::optional<fem::FaceType> face;  ///< dimension 2
};

constexpr ShapeTraits traits(Shape shape) {
  switch (shape) {
    case Shape::point: return {0, 1, {}, {}};
    case Shape::line2: return {1, 2, {}, {}};
    case Shape::line3: return {1, 3, {}, {}};
    case Shape::tri3: return {2, 3, {}, fem::FaceType::tri3};
    case Shape::tri6: return {2, 6, {}, fem::FaceType::tri6};
    case Shape::quad4: return {2, 4, {}, fem::FaceType::quad4};
    case Shape::tet4: return {3, 4, fem::CellType::tet4, {}};
    case Shape::tet10: return {3, 10, fem::CellType::tet10, {}};
    case Shape::hex8: return {3, 8, fem::CellType::hex8, {}};
  }
  return {};
}

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
