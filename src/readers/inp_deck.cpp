#include "ritz/readers/inp_deck.hpp"

#include <algorithm>

namespace ritz::readers {

namespace {

std::string without_blanks(std::string_view text) {
  auto result = upper(text);
  std::erase_if(result, [](char c) { return c == ' ' || c == '\t'; });
  return result;
}

void add_parameters(Keyword& keyword, const Line& line) {
  for (const auto& field : fields(line)) {
    if (field.text.empty()) continue;
    const auto equals = std::min(field.text.find('='), field.text.size());
    const auto value = equals < field.text.size() ? field.text.substr(equals + 1) : std::string_view();
    keyword.parameters.emplace_back(without_blanks(field.text.substr(0, equals)), plain_name(value));
  }
}

// "RIGID  body" -> "RIGID BODY"
std::string title_of(std::string_view text) {
  auto result = upper(trimmed(text));
  std::replace(result.begin(), result.end(), '\t', ' ');
  const auto same = [](char a, char b) { return a == ' ' && b == ' '; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

Keyword keyword_of(Line line) {
  const auto name_end = std::min(line.text.find(','), line.text.size());
  const auto name = line.text.substr(1, name_end - 1);
  Keyword keyword{.name = without_blanks(name), .title = title_of(name), .parameters = {}, .place = line.place};
  const auto parameters = std::min(name_end + 1, line.text.size());
  line.place.offset += parameters;
  line.text.remove_prefix(parameters);
  add_parameters(keyword, line);
  return keyword;
}

struct Flag {
  std::string_view keyword;
  std::string_view name;
};

// The parameters without a value of the keywords that are read.
constexpr Flag flags[] = {{"NSET", "GENERATE"},         {"NSET", "UNSORTED"},  {"NSET", "INTERNAL"},
                          {"ELSET", "GENERATE"},        {"ELSET", "UNSORTED"}, {"ELSET", "INTERNAL"},
                          {"SURFACE", "INTERNAL"},      {"BOUNDARY", "FIXED"}, {"BOUNDARY", "USER"},
                          {"BOUNDARY", "SUBMODEL"},     {"STEP", "NLGEOM"},    {"STEP", "PERTURBATION"},
                          {"SOLIDSECTION", "COMPOSITE"}};

// Of the others nothing hangs on whether a line is data.
constexpr std::string_view with_data[] = {"NODE",    "ELEMENT",      "NSET",        "ELSET",    "SURFACE",
                                          "ELASTIC", "HYPERELASTIC", "ORIENTATION", "DENSITY",  "BOUNDARY",
                                          "CLOAD",   "DLOAD",        "DSLOAD",      "AMPLITUDE"};

enum class Field { assignment, flag, data };

// "WORD=value", a word with a letter in front, so that a number or an empty field is data.
Field kind_of(const std::string& keyword, std::string_view text) {
  const auto word = without_blanks(text.substr(0, text.find('=')));
  const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto of_word = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  if (word.empty() || !is_letter(word.front()) || !std::all_of(word.begin(), word.end(), of_word)) return Field::data;
  if (text.find('=') != std::string_view::npos) return Field::assignment;
  const auto same = [&](const Flag& flag) { return flag.keyword == keyword && flag.name == word; };
  return std::any_of(std::begin(flags), std::end(flags), same) ? Field::flag : Field::data;
}

}  // namespace

bool Keyword::has(std::string_view parameter) const {
  return std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.first == parameter; });
}

std::optional<std::string> Keyword::value(std::string_view parameter) const {
  const auto same = [&](const auto& p) { return p.first == parameter; };
  const auto found = std::find_if(parameters.begin(), parameters.end(), same);
  if (found == parameters.end() || found->second.empty()) return std::nullopt;
  return found->second;
}

std::optional<Line> Deck::next_line() {
  auto line = lines_.next();
  for (; line; line = lines_.next()) {
    characters_read_ += line->text.size() + 1;
    if (!line->text.empty() && !line->text.starts_with("**")) break;
  }
  return line;
}

void Deck::advance() {
  started_ = true;
  while ((ahead_ = next_line()) && ahead_->text.front() == '*') {
    auto keyword = keyword_of(*ahead_);
    if (keyword.name != "INCLUDE") return;
    // Nothing but INPUT= can follow a comma.
    if (ahead_->text.ends_with(',') && !keyword.has("INPUT")) {
      if (const auto more = next_line()) add_parameters(keyword, *more);
    }
    lines_.include(keyword.value("INPUT").value_or(""), keyword.place);
  }
}

std::optional<Line> Deck::next_data() {
  if (!ahead_ || ahead_->text.front() == '*') return std::nullopt;
  const auto line = ahead_;
  advance();
  return line;
}

// Takes the lines that continue a keyword line with a comma at its end.
void Deck::read_continuation(Keyword& keyword) {
  for (bool comma = true; comma && ahead_ && ahead_->text.front() != '*'; advance()) {
    const auto parts = fields(*ahead_);
    const auto count = [&](Field kind) {
      return std::count_if(parts.begin(), parts.end(), [&](auto& f) { return kind_of(keyword.name, f.text) == kind; });
    };
    const auto assignments = count(Field::assignment), data = count(Field::data);
    if (data > 0 && assignments == 0) return;
    if (data > 0 && std::find(std::begin(with_data), std::end(with_data), keyword.name) != std::end(with_data))
      fail(ahead_->place, "this line follows a comma at the end of *" + keyword.title +
                              " and holds parameters and data; write the parameters in the line of the keyword");
    if (assignments == 0) keyword.flag_lines.push_back(*ahead_);
    add_parameters(keyword, *ahead_);
    comma = ahead_->text.ends_with(',');
  }
}

std::optional<Keyword> Deck::next_keyword() {
  if (!started_) advance();
  while (ahead_ && ahead_->text.front() != '*') advance();
  if (!ahead_) return std::nullopt;
  auto keyword = keyword_of(*ahead_);
  const bool comma = ahead_->text.ends_with(',');
  advance();
  if (comma) read_continuation(keyword);
  return keyword;
}

std::vector<Line> fields(const Line& line) {
  std::vector<Line> result;
  const auto begin = line.text.data();
  for (auto rest = line.text; !rest.empty();) {
    bool quoted = false;
    const auto separates = [&](char c) {
      quoted ^= c == '"';
      return c == ',' && !quoted;
    };
    const auto comma = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), separates) - rest.begin());
    const auto text = trimmed(rest.substr(0, comma));
    auto place = line.place;
    place.offset += static_cast<std::uint64_t>((text.empty() ? rest.data() : text.data()) - begin);
    result.push_back({.place = place, .text = text});
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return result;
}

std::string plain_name(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

}  // namespace ritz::readers
