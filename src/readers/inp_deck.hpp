// The keyword lines and data lines of an .inp file.
#pragma once
#include "ritz/readers/source.hpp"

namespace ritz::readers {

/// A keyword line such as "*ELEMENT, TYPE=C3D4, ELSET=Body": names in capitals and without blanks, values as written,
/// without quotes.
struct Keyword {
  std::string name;
  std::string title;  ///< the usual spelling of the name: "RIGID BODY"
  std::vector<std::pair<std::string, std::string>> parameters;
  Place place;
  /// Continuation lines that contain flags alone, such as GENERATE; they could also be names of sets.
  std::vector<Line> flag_lines = {};

  bool has(std::string_view parameter) const;
  std::optional<std::string> value(std::string_view parameter) const;  ///< absent also if it is empty
};

/// Iterates over the lines of a deck, without comments and blank lines, and follows *INCLUDE. A keyword line that ends
/// in a comma continues on the next line if every field there is a parameter (WORD=value, or a flag that the keyword
/// knows); otherwise that line is data, as CalculiX and many writers of decks mean it. A copy reads the same lines
/// again.
class Deck {
 public:
  Deck(Sources& sources, unsigned file) : lines_(sources, file) {}

  /// The next keyword; remaining data lines are skipped.
  std::optional<Keyword> next_keyword();
  /// The next data line of this keyword.
  std::optional<Line> next_data();

  /// The characters of all lines read so far.
  std::size_t characters_read() const { return characters_read_; }

  const Sources& sources() const { return lines_.sources(); }
  Cursor cursor(const Line& line) const { return lines_.cursor(line); }
  [[noreturn]] void fail(Place place, const std::string& message) const { lines_.fail(place, message); }

 private:
  std::optional<Line> next_line();
  void advance();
  void read_continuation(Keyword& keyword);

  Lines lines_;
  std::size_t characters_read_ = 0;
  std::optional<Line> ahead_;
  bool started_ = false;
};

/// The comma-separated fields of a line, trimmed, without an empty field after a last comma. Commas inside quotes do
/// not separate.
std::vector<Line> fields(const Line& line);
/// The form in which names of sets and materials are compared: in capitals, without quotes.
std::string plain_name(std::string_view text);

}  // namespace ritz::readers
