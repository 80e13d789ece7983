// The names of solver_options, by what they belong to.
#pragma once
#include <span>
#include <string_view>

#include "ritz/config/solver_options.hpp"

namespace ritz::config {

/// Every name behind every prefix; lists are parted by blanks.
struct SolverNames {
  SolverOption kind;
  std::string_view prefixes, names;
  std::string_view words = "";  ///< the only values, where there is a list of them
};

std::span<const SolverNames> solver_names();

}  // namespace ritz::config
