// Files held whole in memory, places in them, errors that name a place; a cursor that reads numbers, and lines.
#pragma once
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/readers/file_mesh.hpp"

namespace ritz::readers {

/// How an error names a place in a file: text by its line, binary data by its byte.
enum class Counting { lines, bytes };

struct SourceFile {
  std::filesystem::path path;
  std::string bytes;
  Counting counting = Counting::lines;
};

/// The mesh file (number 0) and the files it includes. A deque, so that views of `bytes` stay valid.
using Sources = std::deque<SourceFile>;

struct Place {
  std::uint64_t file : 8 = 0;
  std::uint64_t offset : 56 = 0;
};

/// Reads a file whole and returns its number. Throws InputError when it is absent, not a file, unreadable or empty.
unsigned open(Sources& sources, const std::filesystem::path& path);

/// "FILE:LINE: ", or "FILE, byte N: " for binary data.
std::string located(const Sources& sources, Place place);

/// Throws InputError("FILE:LINE: message"), or "FILE, byte N: message" for binary data. Of a file that another one
/// includes, what `message` has in quotes ('...') is left out: a foreign file is not shown.
[[noreturn]] void fail(const Sources& sources, Place place, const std::string& message);

/// Throws InputError("FILE: message"), for what is wrong with the mesh file as a whole.
[[noreturn]] void fail(const Sources& sources, const std::string& message);

/// `text` without blanks (space, tab, carriage return) at its ends.
std::string_view trimmed(std::string_view text);
std::string upper(std::string_view text);

/// Walks over the bytes of one source. Space, tab, carriage return and comma separate numbers; a number never
/// continues on another line unless skip_space() is called. Every failure is an InputError that names the line.
class Cursor {
 public:
  Cursor(const Sources& sources, unsigned file);
  Cursor(const Sources& sources, Place begin, std::size_t length);

  Place place() const { return {.file = file_, .offset = position_}; }
  std::size_t remaining() const { return end_ - position_; }
  bool at_end() const { return position_ == end_; }

  void skip_blanks();       ///< what separates numbers of one line
  void skip_space();        ///< the same and line ends
  bool line_ends();         ///< skips blanks; is there nothing more on this line?
  void end_line();          ///< nothing but blanks may follow on this line
  std::string_view line();  ///< the rest of the line without its end, trimmed; moves past it
  std::string_view bytes(std::size_t count, std::string_view what);  ///< raw bytes

  Index integer(std::string_view what);  ///< `what` is named by the error
  double real(std::string_view what);    ///< finite, else an error

  [[noreturn]] void fail(const std::string& message) const { readers::fail(*sources_, place(), message); }

 private:
  std::string_view token() const;
  [[noreturn]] void unexpected(std::string_view what) const;
  double unusual_real(std::string_view what);
  bool separates(const char* next) const;

  const Sources* sources_;
  const char* data_;
  std::size_t position_;
  std::size_t end_;
  unsigned file_;
};

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
  [[noreturn]] void fail(Place place, const std::string& message) const { readers::fail(*sources_, place, message); }

 private:
  std::optional<unsigned> included_before(const std::filesystem::path& path, Place at);

  Sources* sources_;
  std::vector<Cursor> stack_;
  unsigned includes_ = 0;
  std::size_t repeated_bytes_ = 0;  ///< of files that were included before
};

}  // namespace ritz::readers
