// Parses the values of options that name sets.
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

/// A name of a list, and whether it stood in double quotes.
struct ListedName {
  std::string name;
  bool quoted;
};

/// Parses "NAME,..." of this option. Names may be in double quotes, within which ',' is an ordinary character. Throws
/// InputError for an empty one.
std::vector<ListedName> parse_names(const std::string& option, const std::string& text);

/// Parses "SET[:xyz],…", "FILE.bou", "box:x0,x1,y0,y1,z0,z1[:xyz]" or a list of these separated by commas; "none" fixes
/// nothing. A SET may be in double quotes, within which ':' and ',' are ordinary characters. Box coordinates are in
/// `units`. Throws InputError.
Supports parse_supports(const std::string& text, const mesh::Units& units);

}  // namespace ritz::config
