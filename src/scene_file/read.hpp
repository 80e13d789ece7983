// Reads scene files.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// Reads a TOML scene file. Serial. Throws InputError, with file and line, for everything that the documentation of
/// scenes does not allow, such as unknown keys (naming the nearest one), wrong types, step <= 0, end < step, unsorted
/// tables, NaN.
Scene read(const std::filesystem::path& path);

/// The same for the text of a scene file, which errors call `file`.
Scene parse(const std::string& bytes, const std::string& file);

/// A scene with every key that there is, and what each means, its unit and its default as comments.
std::string_view reference();

}  // namespace ritz::scene
