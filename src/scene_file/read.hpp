// Reads scene files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// Reads a TOML scene file. Serial. Throws InputError, with file and line, for everything that the documentation of
/// scenes does not allow, such as unknown keys (naming the nearest one), wrong types, step <= 0, end < step, unsorted
/// tables, NaN.
Scene read(const std::filesystem::path& path);

/// The same for the text of a scene file, which errors call `file`.
Scene parse(const std::string& bytes, const std::string& file);

/// A value of a scene that a program made, of the kinds that TOML has.
struct Value {
  using Array = std::vector<Value>;
  using Table = std::vector<std::pair<std::string, Value>>;
  std::variant<bool, std::int64_t, double, std::string, Array, Table> is;
};

/// The scene of a table with the keys of a scene file. Throws InputError as read does, with `name` in place of file and
/// line. Relative paths count from the current folder.
Scene from_table(const Value::Table& table, const std::string& name);

/// A scene with every key that there is, and what each means, its unit and its default as comments.
std::string_view reference();

}  // namespace ritz::scene
