// The table of all options of ritz-reduce and ritz-full: -help prints it, and misspelt options are compared with it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "ritz/config/config.hpp"

namespace ritz::config {

struct OptionEntry {
  std::string_view name;      ///< without the dash
  std::string_view argument;  ///< "" for a flag
  std::string_view unit;      ///< unit and range
  std::string_view fallback;  ///< the default
  std::string_view text;
};

/// All options of a program, in the order of -help.
std::vector<OptionEntry> option_table(Program program);

/// Every name that a command line or an options file may hold: those of both programs, for they may share a file.
std::vector<std::string_view> option_names();

/// What -help prints, no line of it longer than 100 characters: examples first, then the program's own options by
/// topic.
std::string help_text(Program program);

}  // namespace ritz::config
