// What ritz-inspect prints of a model, as numbers: --summary FILE.json, described in docs/summary.md.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "inspect_check.hpp"
#include "ritz/files/json.hpp"
#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// `checked`: what --check measured, a body each; nothing where it was not asked for.
files::Json summary(const format::ModelReader& in, const std::optional<std::vector<CheckedBody>>& checked);

/// Writes a summary's text to `path`, which gets its name when it is whole. Throws InputError where it cannot be
/// created or is the model itself, and NumericalError where the disk does not take it.
void write_summary(const files::Json& summary, const std::filesystem::path& path, const format::ModelReader& in);

}  // namespace ritz::tools
