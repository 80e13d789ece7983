// Typed access to a TOML file, and a check before it is parsed; every error names file and line.
#pragma once
#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// Throws InputError, with file and line, when a key or a table heading of the TOML text has more parts than any key of
/// a scene needs. The parser itself limits nested arrays and inline tables.
void refuse_deep_keys(const std::string& text, const std::string& file);

/// A value of the file and its name in messages, such as "step of [time]".
struct Entry {
  const toml::node& node;
  std::string file;
  std::string name;
};

/// Throws InputError "file:line: message", or "file: message" for a value that a program made.
[[noreturn]] void fail(const Entry& entry, const std::string& message);

// Each returns the value of the entry, or throws an InputError that says what it must be. Numbers are finite.
double number(const Entry& entry);
double positive(const Entry& entry);
double not_negative(const Entry& entry);
std::int64_t integer(const Entry& entry);
std::string text(const Entry& entry);
std::vector<double> numbers(const Entry& entry);
Vector3 vector3(const Entry& entry);
Table table(const Entry& entry);

/// A TOML table whose keys are all allowed.
class Section {
 public:
  /// Throws InputError when `entry` is not a table, and for a key that is not in `known`, naming the nearest one.
  Section(const Entry& entry, std::initializer_list<std::string_view> known);

  /// The entry of a key, if it is present.
  std::optional<Entry> find(std::string_view key) const;
  /// The entry of a key. Throws InputError when it is missing.
  Entry get(std::string_view key) const;
  /// The only one of these keys that is present; empty if none is. Throws InputError when there are several.
  std::string_view one_of(std::initializer_list<std::string_view> keys) const;

  const Entry& entry() const { return entry_; }

 private:
  Entry entry_;
  const toml::table* table_;
};

/// The sections of an array of tables, [[key]]; none if `key` is missing.
std::vector<Section> sections(const Section& parent, std::string_view key,
                              std::initializer_list<std::string_view> known);

}  // namespace ritz::scene
