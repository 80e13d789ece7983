#include "entry.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::scene {
namespace {

constexpr int most_parts = 16;

/// The length of the string that begins at `text`, with its quotes: to the end of the line, or of the text, where it is
/// not closed.
std::size_t string_length(std::string_view text) {
  const char quote = text[0];
  const std::string triple(3, quote);
  const bool long_one = text.starts_with(triple);
  std::size_t i = long_one ? 3 : 1;
  for (; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') ++i;
    else if (long_one ? text.substr(i).starts_with(triple) : text[i] == quote) return i + (long_one ? 3 : 1);
    else if (!long_one && text[i] == '\n') return i;
  }
  return text.size();
}

}  // namespace

void refuse_deep_keys(const std::string& text, const std::string& file) {
  const std::string_view all = text;
  int dots = 0;
  for (std::size_t i = 0; i < all.size();) {
    const char c = all[i];
    if (c == '"' || c == '\'') {
      i += string_length(all.substr(i));
      continue;
    }
    if (c == '#') {
      i = std::min(all.find('\n', i), all.size());
      continue;
    }
    if (c == '.') ++dots;
    else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (dots >= most_parts)
      throw InputError(
          file + ":" +
          std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n')) +
          ": a key has more than " + std::to_string(most_parts) + " parts, and no scene has such a one");
    ++i;
  }
}

namespace {

std::string quote(std::string_view word) { return "'" + printable(word) + "'"; }

const toml::array& array(const Entry& entry, const std::string& wanted) {
  if (const auto* array = entry.node.as_array()) return *array;
  fail(entry, entry.name + " must be " + wanted);
}

/// "file:line"; what a program made has no lines.
std::string place(const std::string& file, const toml::source_region& source) {
  return source.begin.line == 0 ? file : file + ":" + std::to_string(source.begin.line);
}

}  // namespace

void fail(const Entry& entry, const std::string& message) {
  throw InputError(place(entry.file, entry.node.source()) + ": " + message);
}

double number(const Entry& entry) {
  const auto value = entry.node.is_number() ? entry.node.value<double>() : std::nullopt;
  if (!value) fail(entry, entry.name + " must be a number");
  if (!std::isfinite(*value)) fail(entry, entry.name + " must be a finite number");
  return *value;
}

double positive(const Entry& entry) {
  const double value = number(entry);
  if (value <= 0) fail(entry, entry.name + " must be greater than 0");
  return value;
}

double not_negative(const Entry& entry) {
  const double value = number(entry);
  if (value < 0) fail(entry, entry.name + " must not be negative");
  return value;
}

std::int64_t integer(const Entry& entry) {
  if (!entry.node.is_integer()) fail(entry, entry.name + " must be a whole number");
  return *entry.node.value<std::int64_t>();
}

std::string text(const Entry& entry) {
  const auto value = entry.node.value_exact<std::string>();
  if (!value) fail(entry, entry.name + " must be a string");
  return *value;
}

std::vector<double> numbers(const Entry& entry) {
  std::vector<double> values;
  for (const auto& item : array(entry, "an array of numbers")) values.push_back(number({item, entry.file, entry.name}));
  return values;
}

Vector3 vector3(const Entry& entry) {
  const auto values = numbers(entry);
  if (values.size() != 3) fail(entry, entry.name + " must have three components [x, y, z]");
  return {values[0], values[1], values[2]};
}

Table table(const Entry& entry) {
  Table table;
  for (const auto& item : array(entry, "an array of [t, value] pairs")) {
    const Entry row{item, entry.file, entry.name};
    const auto pair = numbers(row);
    if (pair.size() != 2) fail(row, "each row of " + entry.name + " must be a pair [t, value]");
    if (!table.points.empty() && pair[0] <= table.points.back().first)
      fail(row, "the times of " + entry.name + " must ascend strictly");
    table.points.emplace_back(pair[0], pair[1]);
  }
  if (table.points.empty()) fail(entry, entry.name + " must have at least one pair [t, value]");
  return table;
}

Section::Section(const Entry& entry, std::initializer_list<std::string_view> known)
    : entry_(entry), table_(entry.node.as_table()) {
  if (table_ == nullptr) fail(entry, entry.name + " must be a table of keys");
  for (const auto& [key, node] : *table_) {
    const std::string_view word = key.str();
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    throw InputError(place(entry.file, key.source()) + ": unknown key " + quote(word) + " in " + entry.name +
                     hint(word, known));
  }
}

std::optional<Entry> Section::find(std::string_view key) const {
  const auto* node = table_->get(key);
  if (node == nullptr) return std::nullopt;
  return Entry{*node, entry_.file, quote(key) + " of " + entry_.name};
}

Entry Section::get(std::string_view key) const {
  if (auto entry = find(key)) return *entry;
  fail(entry_, entry_.name + " needs the key " + quote(key));
}

std::string_view Section::one_of(std::initializer_list<std::string_view> keys) const {
  std::string_view found;
  for (const auto key : keys) {
    if (!table_->contains(key)) continue;
    if (!found.empty())
      fail(*find(key), entry_.name + " has both " + quote(found) + " and " + quote(key) + ": keep one of them");
    found = key;
  }
  return found;
}

std::vector<Section> sections(const Section& parent, std::string_view key,
                              std::initializer_list<std::string_view> known) {
  std::vector<Section> result;
  const auto entry = parent.find(key);
  if (!entry) return result;
  const std::string name = "[[" + std::string(key) + "]]";
  for (const auto& item : array({entry->node, entry->file, name}, "an array of tables, each headed " + name))
    result.emplace_back(Entry{item, entry->file, name}, known);
  return result;
}

}  // namespace ritz::scene
