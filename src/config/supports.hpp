// Parses the value of -fix.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"

namespace ritz::config {

struct Supports {
  std::vector<mesh::Fixed> fixed;
  std::vector<std::filesystem::path> vertex_lists;  ///< .bou files, each in `fixed` as a set with its path as name
};

/// Parses "SET[:xyz],…", "FILE.bou", "box:x0,x1,y0,y1,z0,z1[:xyz]" or a list of these separated by commas; "none" fixes
/// nothing. A SET may be in double quotes, within which ':' and ',' are ordinary characters. Box coordinates are in
/// `units`. Throws InputError.
Supports parse_supports(const std::string& text, const mesh::Units& units);

}  // namespace ritz::config
