// The names of solver options, by kind.
#pragma once
#include <span>
#include <string_view>

#include "ritz/config/solver_options.hpp"

namespace ritz::config {

/// All combinations of these prefixes and names; lists are separated by blanks.
struct SolverNames {
  SolverOption kind;
  std::string_view prefixes, names;
  std::string_view words = "";  ///< the only values allowed, if there is a list of them
};

std::span<const SolverNames> solver_names();

}  // namespace ritz::config
