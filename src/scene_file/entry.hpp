// Typed access to a parsed TOML file in which every complaint names file and line.
#pragma once
#include <toml++/toml.h>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// A value of the file and what to call it: "step of [time]".
struct Entry {
  const toml::node& node;
  std::string file;
  std::string name;
};

/// Throws InputError "file:line: message".
[[noreturn]] void fail(const Entry& entry, const std::string& message);

// Each returns the entry's value, or fails saying what the entry must be. Numbers are finite.
double number(const Entry& entry);
double positive(const Entry& entry);
double not_negative(const Entry& entry);
std::int64_t integer(const Entry& entry);
std::string text(const Entry& entry);
std::vector<double> numbers(const Entry& entry);
Vector3 vector3(const Entry& entry);
Table table(const Entry& entry);

/// A TOML table that has only keys it may have.
class Section {
 public:
  /// Fails when `entry` is not a table, or for a key that is not in `known`, naming the nearest one.
  Section(const Entry& entry, std::initializer_list<std::string_view> known);

  std::optional<Entry> find(std::string_view key) const;
  /// Fails when the key is missing.
  Entry get(std::string_view key) const;
  /// The one of these keys that is there, empty when none is; fails when there are two.
  std::string_view one_of(std::initializer_list<std::string_view> keys) const;

  const Entry& entry() const { return entry_; }

 private:
  Entry entry_;
  const toml::table* table_;
};

/// The sections of an array of tables, [[key]]; none when `key` is missing.
std::vector<Section> sections(const Section& parent, std::string_view key,
                              std::initializer_list<std::string_view> known);

}  // namespace ritz::scene
