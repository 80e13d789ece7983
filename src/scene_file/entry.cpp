#include "entry.hpp"

#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::scene {
namespace {

std::string quote(std::string_view word) { return "'" + printable(word) + "'"; }

const toml::array& array(const Entry& entry, const std::string& wanted) {
  if (const auto* array = entry.node.as_array()) return *array;
  fail(entry, entry.name + " must be " + wanted);
}

}  // namespace

void fail(const Entry& entry, const std::string& message) {
  throw InputError(entry.file + ":" + std::to_string(entry.node.source().begin.line) + ": " + message);
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
    throw InputError(entry.file + ":" + std::to_string(key.source().begin.line) + ": unknown key " + quote(word) +
                     " in " + entry.name + hint(word, known));
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
