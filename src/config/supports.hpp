// The words of -fix.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/units.hpp"

namespace ritz::config {

struct Supports {
  std::vector<mesh::Fixed> fixed;
  std::vector<std::filesystem::path> vertex_lists;  ///< .bou files; each stands among `fixed` as a set of its name
};

/// "SET[:xyz],…", "FILE.bou", "box:x0,x1,y0,y1,z0,z1[:xyz]", or a list of these separated by commas; "none" holds
/// nothing. A SET may stand in double quotes, within which ':' and ',' are its own. Lengths of boxes are in `units`.
/// Throws InputError.
Supports parse_supports(const std::string& text, const mesh::Units& units);

}  // namespace ritz::config
