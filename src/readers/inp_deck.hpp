// The keyword lines and data lines of an .inp file.
#pragma once
#include "ritz/readers/source.hpp"

namespace ritz::readers {

/// "*ELEMENT, TYPE=C3D4, ELSET=Body": names in capitals and without blanks, values as written without quotes.
struct Keyword {
  std::string name;
  std::string title;  ///< the name as people know it: "RIGID BODY"
  std::vector<std::pair<std::string, std::string>> parameters;
  Place place;
  /// Continuation lines that state flags alone, such as GENERATE: names of sets could be meant.
  std::vector<Line> flag_lines = {};

  bool has(std::string_view parameter) const;
  std::optional<std::string> value(std::string_view parameter) const;  ///< absent also when empty
};

/// Comments and blank lines left out, *INCLUDE followed. A keyword line that ends in a comma goes on in the next line
/// where each field of that is a parameter (WORD=value, or a flag that the keyword knows); else that line is data, as
/// CalculiX and many writers of decks mean it.
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
  std::optional<Line> next_line();
  void advance();
  void read_continuation(Keyword& keyword);

  Lines lines_;
  std::optional<Line> ahead_;
  bool started_ = false;
};

/// The comma-separated fields of a line, trimmed; one after a last comma is left out. Commas inside quotes do not
/// separate.
std::vector<Line> fields(const Line& line);
/// Set and material names are compared so: in capitals, without quotes.
std::string plain_name(std::string_view text);

}  // namespace ritz::readers
