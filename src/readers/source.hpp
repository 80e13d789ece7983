// Files held in memory as a whole, places in them, errors that name a place, a cursor that reads numbers, and lines.
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

/// How errors name a place in a file: by line for text, by byte for binary data.
enum class Counting { lines, bytes };

struct SourceFile {
  std::filesystem::path path;
  std::string bytes;
  Counting counting = Counting::lines;
};

/// The mesh file (number 0) and the files that it includes. A deque, so that views of `bytes` stay valid.
using Sources = std::deque<SourceFile>;

/// A place in a file: the file's number and the offset in bytes.
struct Place {
  std::uint64_t file : 8 = 0;
  std::uint64_t offset : 56 = 0;
};

/// Reads a whole file and returns its number. Throws InputError when it does not exist, is not a file, cannot be read
/// or is empty.
unsigned open(Sources& sources, const std::filesystem::path& path);

/// "FILE:LINE: ", or "FILE, byte N: " for binary data.
std::string located(const Sources& sources, Place place);

/// Throws InputError("FILE:LINE: message"), or "FILE, byte N: message" for binary data. In a file that another one
/// includes, quoted parts ('...') of `message` are left out, so that contents of foreign files are not shown.
[[noreturn]] void fail(const Sources& sources, Place place, const std::string& message);

/// Throws InputError("FILE: message"), for errors of the mesh file as a whole.
[[noreturn]] void fail(const Sources& sources, const std::string& message);

/// `text` without blanks (space, tab, carriage return) at its ends.
std::string_view trimmed(std::string_view text);
std::string upper(std::string_view text);

/// Reads the bytes of one source. Space, tab, carriage return and comma separate numbers; reading a number never
/// continues on the next line unless skip_space() is called. Every failure is an InputError that names the line.
class Cursor {
 public:
  Cursor(const Sources& sources, unsigned file);
  Cursor(const Sources& sources, Place begin, std::size_t length);

  Place place() const { return {.file = file_, .offset = position_}; }
  std::size_t remaining() const { return end_ - position_; }
  bool at_end() const { return position_ == end_; }

  void skip_blanks();       ///< skips what separates numbers of one line
  void skip_space();        ///< the same, and line ends
  bool line_ends();         ///< skips blanks; true if the line has nothing more
  void end_line();          ///< fails unless only blanks follow on this line
  std::string_view line();  ///< the rest of the line, trimmed; continues after its end
  std::string_view bytes(std::size_t count, std::string_view what);  ///< raw bytes

  Index integer(std::string_view what);  ///< `what` is its name in errors
  double real(std::string_view what);    ///< finite, otherwise an error

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

/// Iterates over lines; include() inserts the lines of another file.
class Lines {
 public:
  Lines(Sources& sources, unsigned file);

  /// The next line, also if it is blank; nothing at the end of the outermost file.
  std::optional<Line> next();
  /// Continues with the file of that name, relative to the file that contains `at`. Throws InputError when it cannot be
  /// read, includes itself, or when repeated inclusions would read without end.
  void include(std::string_view name, Place at);

  const Sources& sources() const { return *sources_; }
  Cursor cursor(const Line& line) const { return {*sources_, line.place, line.text.size()}; }
  [[noreturn]] void fail(Place place, const std::string& message) const { readers::fail(*sources_, place, message); }

 private:
  std::optional<unsigned> included_before(const std::filesystem::path& path, Place at);

  Sources* sources_;
  std::vector<Cursor> stack_;
  unsigned includes_ = 0;
  std::size_t repeated_bytes_ = 0;  ///< of files that had been included before
};

}  // namespace ritz::readers
