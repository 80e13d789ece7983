// The parts of a reader of .msh files: encoding, element types, physical groups, and the sections of each version.
#pragma once
#include <map>

#include "ritz/readers/groups.hpp"
#include "ritz/readers/source.hpp"

namespace ritz::readers {

enum class MshEncoding { text, binary };

/// A cursor that knows how numbers are encoded.
struct MshInput {
  Cursor cursor;
  MshEncoding encoding = MshEncoding::text;

  Index integer(std::string_view what);  ///< 4 bytes when binary
  Index size(std::string_view what);     ///< 8 bytes when binary
  double real(std::string_view what);
  /// Reads a count (as size()) of items of at least `values` numbers each, and checks it against the rest of the file.
  Index count(std::string_view what, Index values);
  /// Throws InputError unless `count` items of `values` numbers each fit into the rest of the file.
  void check_count(Index count, std::string_view what, Index values) const;
  void begin_record();  ///< in text: skips line ends
  void end_record();    ///< in text: the line must end here
  void open_binary();   ///< after a count that is text in both encodings
  void close_section(std::string_view name);

  Place place() const { return cursor.place(); }
  [[noreturn]] void fail(const std::string& message) const { cursor.fail(message); }
};

/// Skips a section whose first line, at `place`, has been read. Binary data may contain anything, also line ends and
/// "$End", and need not end with a line break. Throws InputError for a section without an end.
void skip_msh_section(const Sources& sources, MshInput& input, const std::string& name, Place place);

/// The shape of Gmsh's element type `type`. Throws an InputError that names a type for which ritz has no element.
Shape msh_shape(const MshInput& input, Index type);

/// Reorders the vertices of a cell from Gmsh's order to that of fem/cell.hpp.
void reorder_from_msh(Shape shape, std::span<Index> vertices);

/// Adds the cell that was listed last to a physical group. Tag 0 means none; a negative tag is the group with reversed
/// orientation.
void join_physical(Groups& groups, ListedMesh& mesh, Index tag);

/// Reads the section $PhysicalNames.
void read_physical_names(MshInput& input, Groups& groups);

/// A .msh file while it is being read.
struct MshFile {
  MshInput input;
  ListedMesh mesh;
  Groups groups;
  std::map<Groups::Key, std::vector<Index>> entities;  ///< 4.1: (dimension, entity) -> physical tags
  /// 4.1: how many memberships of cells in groups are still allowed. An entity in very many groups would take few bytes
  /// in the file but much memory.
  std::size_t memberships_left = 0;
};

/// Reads $Nodes and $ParametricNodes; the latter also says where each vertex lies on the geometry.
void read_msh2_nodes(MshFile& msh);
void read_msh2_parametric_nodes(MshFile& msh);
void read_msh2_elements(MshFile& msh);

void read_msh4_entities(MshFile& msh);
/// Reads the entities of a partitioned mesh, which have parents and partitions.
void read_msh4_partitioned_entities(MshFile& msh);
void read_msh4_nodes(MshFile& msh);
void read_msh4_elements(MshFile& msh);

}  // namespace ritz::readers
