// The values of a .msh section, which are the same in text and in binary files.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

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

}  // namespace ritz::mesh
