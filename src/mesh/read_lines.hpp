// The lines of a text file and of the files it includes.
#pragma once
#include <optional>
#include <vector>

#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

struct Line {
  Place place;            ///< where `text` begins
  std::string_view text;  ///< trimmed
};

/// Walks over lines; include() inserts another file's lines here.
class Lines {
 public:
  Lines(Sources& sources, unsigned file);

  /// The next line, blank ones too; empty at the end of the outermost file.
  std::optional<Line> next();
  /// Goes on with the file of that name, relative to the file that `at` is in. Throws InputError when it cannot be
  /// read, includes itself, or when files that include each other again and again would be read without end.
  void include(std::string_view name, Place at);

  const Sources& sources() const { return *sources_; }
  Cursor cursor(const Line& line) const { return {*sources_, line.place, line.text.size()}; }
  [[noreturn]] void fail(Place place, const std::string& message) const { mesh::fail(*sources_, place, message); }

 private:
  std::optional<unsigned> included_before(const std::filesystem::path& path, Place at);

  Sources* sources_;
  std::vector<Cursor> stack_;
  unsigned includes_ = 0;
  std::size_t repeated_bytes_ = 0;  ///< of files that were included before
};

}  // namespace ritz::mesh
