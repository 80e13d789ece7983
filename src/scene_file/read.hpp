// Scene files.
#pragma once
#include <filesystem>
#include <string>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// Reads a TOML scene file. Serial. Throws InputError with file and line for anything that is not as documented:
/// unknown keys (naming the nearest one), wrong types, step <= 0, end < step, unsorted tables, NaN.
Scene read(const std::filesystem::path& path);

/// The same of the text of a scene file, which errors call `file`.
Scene parse(const std::string& bytes, const std::string& file);

}  // namespace ritz::scene
