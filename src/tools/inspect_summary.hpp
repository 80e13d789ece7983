// What ritz-inspect prints of a model, as numbers: --summary FILE.json, described in docs/summary.md.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "inspect_check.hpp"
#include "ritz/files/claim.hpp"
#include "ritz/files/json.hpp"
#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// `checked`: what --check measured, a body each; nothing where it was not asked for.
files::Json summary(const format::ModelReader& in, const std::optional<std::vector<CheckedBody>>& checked);

/// Takes the name `path` for the summary of a model. Throws InputError where it cannot be written to or is the model.
files::Claim claim_summary(const std::filesystem::path& path, const std::filesystem::path& model);

/// Writes a summary to `path`, which gets its name when it is complete. Throws InputError or NumericalError where it
/// cannot be written.
void write_summary(const files::Json& summary, const std::filesystem::path& path, const files::Claim& claim);

}  // namespace ritz::tools
