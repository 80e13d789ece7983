// A .msh file as it is read: its encoding, element types and physical groups, and the sections of each version.
#pragma once
#include <map>

#include "ritz/readers/groups.hpp"
#include "ritz/readers/source.hpp"

namespace ritz::readers {

enum class MshEncoding { text, binary };

/// A cursor that knows how numbers are written.
struct MshInput {
  Cursor cursor;
  MshEncoding encoding = MshEncoding::text;

  Index integer(std::string_view what);  ///< 4 bytes when binary
  Index size(std::string_view what);     ///< 8 bytes when binary
  double real(std::string_view what);
  /// A count (as size) of things of at least `values` numbers each. Checked against what is left of the file.
  Index count(std::string_view what, Index values);
  /// Throws unless so many things of so many numbers can be in the rest of the file.
  void check_count(Index count, std::string_view what, Index values) const;
  void begin_record();  ///< skips line ends in text
  void end_record();    ///< the line must end here in text
  void open_binary();   ///< after a count that is text in both encodings
  void close_section(std::string_view name);

  Place place() const { return cursor.place(); }
  [[noreturn]] void fail(const std::string& message) const { cursor.fail(message); }
};

/// Moves past a section whose first line has been read, at `place`. Binary data may contain anything, also line ends
/// and
/// "$End", and need not end with a line break. Throws InputError for a section without an end.
void skip_msh_section(const Sources& sources, MshInput& input, const std::string& name, Place place);

/// The shape of Gmsh's element type `type`. Throws InputError naming a type that ritz has no element for.
Shape msh_shape(const MshInput& input, Index type);

/// Turns Gmsh's order of a cell's vertices into that of fem/cell.hpp.
void reorder_from_msh(Shape shape, std::span<Index> vertices);

/// Puts the cell listed last into a physical group; tag 0 is none, a negative one its reverse.
void join_physical(Groups& groups, ListedMesh& mesh, Index tag);

/// The body of $PhysicalNames.
void read_physical_names(MshInput& input, Groups& groups);

/// A .msh file as far as it has been read.
struct MshFile {
  MshInput input;
  ListedMesh mesh;
  Groups groups;
  std::map<Groups::Key, std::vector<Index>> entities;  ///< 4.1: (dimension, entity) -> physical tags
  /// 4.1: how many cells of groups may follow. An entity in very many groups would have few bytes and much memory.
  std::size_t memberships_left = 0;
};

/// $Nodes and, with where each vertex lies on the geometry, $ParametricNodes.
void read_msh2_nodes(MshFile& msh);
void read_msh2_parametric_nodes(MshFile& msh);
void read_msh2_elements(MshFile& msh);

void read_msh4_entities(MshFile& msh);
/// A partitioned mesh has entities of its own, with their parents and partitions.
void read_msh4_partitioned_entities(MshFile& msh);
void read_msh4_nodes(MshFile& msh);
void read_msh4_elements(MshFile& msh);

}  // namespace ritz::readers
