#include "ritz/mesh/read_inp_deck.hpp"

#include <algorithm>

namespace ritz::mesh {
namespace {

std::string without_blanks(std::string_view text) {
  auto result = upper(text);
  std::erase_if(result, [](char c) { return c == ' ' || c == '\t'; });
  return result;
}

void add_parameters(Keyword& keyword, const Line& line) {
  for (const auto& field : fields(line)) {
    const auto equals = std::min(field.text.find('='), field.text.size());
    const auto value = equals < field.text.size() ? field.text.substr(equals + 1) : std::string_view();
    keyword.parameters.emplace_back(without_blanks(field.text.substr(0, equals)), plain_name(value));
  }
}

Keyword keyword_of(Line line) {
  Keyword keyword{.name = {}, .parameters = {}, .place = line.place};
  const auto name_end = std::min(line.text.find(','), line.text.size());
  keyword.name = without_blanks(line.text.substr(1, name_end - 1));
  const auto parameters = std::min(name_end + 1, line.text.size());
  line.place.offset += parameters;
  line.text.remove_prefix(parameters);
  add_parameters(keyword, line);
  return keyword;
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

void Deck::advance() {
  started_ = true;
  while ((ahead_ = lines_.next())) {
    if (ahead_->text.empty() || ahead_->text.starts_with("**")) continue;
    if (ahead_->text.front() != '*') return;
    const auto keyword = keyword_of(*ahead_);
    if (keyword.name != "INCLUDE") return;
    lines_.include(keyword.value("INPUT").value_or(""), keyword.place);
  }
}

std::optional<Line> Deck::next_data() {
  if (!ahead_ || ahead_->text.front() == '*') return std::nullopt;
  const auto line = ahead_;
  advance();
  return line;
}

std::optional<Keyword> Deck::next_keyword() {
  if (!started_) advance();
  while (ahead_ && ahead_->text.front() != '*') advance();
  if (!ahead_) return std::nullopt;
  auto keyword = keyword_of(*ahead_);
  bool continues = ahead_->text.ends_with(',');
  for (advance(); continues && ahead_; advance()) {
    continues = ahead_->text.ends_with(',');
    add_parameters(keyword, *ahead_);
  }
  return keyword;
}

std::vector<Line> fields(const Line& line) {
  std::vector<Line> result;
  const auto begin = line.text.data();
  for (auto rest = line.text; !rest.empty();) {
    const auto comma = std::min(rest.find(','), rest.size());
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

}  // namespace ritz::mesh
