#include "ritz/config/supports.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why, const std::string& option = "fix") {
  throw InputError("option -" + option + " " + text + ": " + why);
}

/// A word of the list: the name that it begins with in double quotes, if any, and what stands after it.
struct Word {
  std::optional<std::string> quoted;
  std::string rest;
};

/// Commas part words; not those within the double quotes that a word begins with.
std::vector<Word> split(const std::string& text, const std::string& option) {
  std::vector<Word> words;
  std::size_t at = 0;
  for (bool more = true; more; ++at) {
    auto& word = words.emplace_back();
    if (at < text.size() && text[at] == '"') {
      const auto close = text.find('"', at + 1);
      if (close == text.npos) refuse(text, "the quote before '" + text.substr(at + 1) + "' is not closed", option);
      word.quoted = text.substr(at + 1, close - at - 1);
      at = close + 1;
    }
    const auto end = std::min(text.find(',', at), text.size());
    word.rest = text.substr(at, end - at);
    more = end < text.size();
    at = end;
  }
  return words;
}

/// The components that ":xyz" at the end of a word names; none where nothing of the kind stands there.
std::optional<std::array<bool, mesh::components>> components_of(const std::string& word) {
  const auto colon = word.rfind(':');
  if (colon == word.npos || colon + 1 == word.size()) return std::nullopt;
  const auto letters = std::string_view(word).substr(colon + 1);
  if (letters.find_first_not_of("xyz") != letters.npos) return std::nullopt;
  const auto has = [&](char c) { return letters.find(c) != letters.npos; };
  return std::array{has('x'), has('y'), has('z')};
}

/// Takes ":xyz" off the end of a box's last number.
std::array<bool, mesh::components> take_components(std::string& word, const std::string& text) {
  const auto colon = word.rfind(':');
  if (colon == word.npos) return {true, true, true};
  const auto fixed = components_of(word);
  if (!fixed) refuse(text, "'" + word.substr(colon + 1) + "' are no components; write some of xyz after the colon");
  word.erase(colon);
  return *fixed;
}

double number(const std::string& word, const std::string& text) {
  double value = 0;
  const char* begin = word.data();
  while (*begin == ' ') ++begin;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || std::isnan(value))
    refuse(text, "'" + word + "' is not a number; a box is box:x0,x1,y0,y1,z0,z1");
  return value;
}

/// Six words from `first` on: "box:x0", x1, y0, y1, z0, "z1[:xyz]".
mesh::Fixed box(std::span<const Word> from, const mesh::Units& units, const std::string& text) {
  std::vector<std::string> words;
  for (const auto& word : from) words.push_back(word.rest);
  mesh::Fixed fixed;
  fixed.text = text;
  words[0].erase(0, 4);
  fixed.fixed = take_components(words[5], text);
  mesh::Region3 region;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto i = static_cast<Eigen::Index>(d);
    region.low[i] = number(words[2 * d], text) * units.length;
    region.high[i] = number(words[2 * d + 1], text) * units.length;
    if (region.low[i] > region.high[i]) refuse(text, "the box is inside out; each pair is a lower and an upper bound");
  }
  fixed.where = region;
  return fixed;
}

/// A set: "NAME", "NAME:xyz", or either with the name in double quotes.
mesh::Fixed named(const Word& word, const std::string& text) {
  mesh::Fixed fixed;
  fixed.text = text;
  const auto components = components_of(word.rest);
  const auto& all = word.rest;
  if (word.quoted && !all.empty() && (!components || all.rfind(':') != 0))
    refuse(text, "'" + all + "' follows a name in quotes; write some of :xyz there");
  if (components) fixed.fixed = *components;
  if (components && !word.quoted) fixed.whole_name = all;
  const auto name = word.quoted ? *word.quoted : components ? all.substr(0, all.rfind(':')) : all;
  if (name.empty()) refuse(text, "there is an empty name in the list");
  fixed.where = name;
  return fixed;
}

}  // namespace

std::vector<ListedName> parse_names(const std::string& option, const std::string& text) {
  std::vector<ListedName> names;
  for (const auto& [quoted, rest] : split(text, option)) {
    if (quoted && !rest.empty()) refuse(text, "'" + rest + "' follows a name in quotes; put a comma between", option);
    names.push_back({quoted.value_or(rest), quoted.has_value()});
    if (names.back().name.empty()) refuse(text, "there is an empty name in the list", option);
  }
  return names;
}

Supports parse_supports(const std::string& text, const mesh::Units& units) {
  Supports supports;
  if (text == "none") return supports;
  const auto words = split(text, "fix");
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].quoted && words[i].rest.starts_with("box:")) {
      if (i + 6 > words.size()) refuse(text, "a box needs six numbers, box:x0,x1,y0,y1,z0,z1");
      supports.fixed.push_back(box(std::span(words).subspan(i, 6), units, text));
      i += 5;
      continue;
    }
    if (!words[i].quoted && words[i].rest == "none") refuse(text, "'none' stands alone");
    supports.fixed.push_back(named(words[i], text));
    const auto& name = std::get<std::string>(supports.fixed.back().where);
    if (name.ends_with(".bou")) supports.vertex_lists.emplace_back(name);
  }
  return supports;
}

}  // namespace ritz::config
