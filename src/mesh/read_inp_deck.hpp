// The keyword lines and data lines of an .inp file.
#pragma once
#include "ritz/mesh/read_lines.hpp"

namespace ritz::mesh {

/// "*ELEMENT, TYPE=C3D4, ELSET=Body": names in capitals and without blanks, values as written without quotes.
struct Keyword {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;
  Place place;

  bool has(std::string_view parameter) const;
  std::optional<std::string> value(std::string_view parameter) const;  ///< absent also when empty
};

/// Comments and blank lines left out, *INCLUDE followed.
class Deck {
 public:
  Deck(Sources& sources, unsigned file) : lines_(sources, file) {}

  /// The next keyword, past whatever data lines are left.
  std::optional<Keyword> next_keyword();
  /// The next data line of this keyword.
  std::optional<Line> next_data();

  const Sources& sources() const { return lines_.sources(); }
  Cursor cursor(const Line& line) const { return lines_.cursor(line); }
  [[noreturn]] void fail(Place place, const std::string& message) const { lines_.fail(place, message); }

 private:
  void advance();

  Lines lines_;
  std::optional<Line> ahead_;
  bool started_ = false;
};

/// The comma-separated fields of a data line, trimmed; one after a last comma is left out.
std::vector<Line> fields(const Line& line);
/// Set and material names are compared so: in capitals, without quotes.
std::string plain_name(std::string_view text);

}  // namespace ritz::mesh
