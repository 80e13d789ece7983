#include "ritz/config/supports.hpp"

#include <charconv>
#include <cmath>

#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError("option -fix " + text + ": " + why);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') words.emplace_back();
    else words.back() += c;
  }
  return words;
}

/// Takes ":xyz" off the end of a word; all three components where there is none.
std::array<bool, mesh::components> take_components(std::string& word, const std::string& text) {
  const auto colon = word.rfind(':');
  if (colon == word.npos || colon + 1 == word.size()) return {true, true, true};
  const std::string letters = word.substr(colon + 1);
  if (letters.find_first_not_of("xyz") != letters.npos) {
    if (word.find('.') != word.npos) return {true, true, true};
    refuse(text, "'" + letters + "' are no components; write some of xyz after the colon");
  }
  word.erase(colon);
  return {letters.find('x') != letters.npos, letters.find('y') != letters.npos, letters.find('z') != letters.npos};
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
mesh::Fixed box(std::vector<std::string> words, const mesh::Units& units, const std::string& text) {
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

}  // namespace

Supports parse_supports(const std::string& text, const mesh::Units& units) {
  Supports supports;
  if (text == "none") return supports;
  const auto words = split(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    if (word.starts_with("box:")) {
      if (i + 6 > words.size()) refuse(text, "a box needs six numbers, box:x0,x1,y0,y1,z0,z1");
      const auto from = words.begin() + static_cast<std::ptrdiff_t>(i);
      supports.fixed.push_back(box({from, from + 6}, units, text));
      i += 5;
      continue;
    }
    mesh::Fixed fixed;
    fixed.text = text;
    fixed.fixed = take_components(word, text);
    if (word.empty()) refuse(text, "there is an empty name in the list");
    if (word == "none") refuse(text, "'none' stands alone");
    if (word.ends_with(".bou")) supports.vertex_lists.emplace_back(word);
    fixed.where = word;
    supports.fixed.push_back(fixed);
  }
  return supports;
}

}  // namespace ritz::config
