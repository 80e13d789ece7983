// The table of all options of ritz-reduce and ritz-full: -help prints it, and misspelt options are compared with it.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ritz::config {

struct OptionEntry {
  std::string_view name;      ///< without the dash
  std::string_view argument;  ///< "" for a flag
  std::string_view unit;      ///< unit and range
  std::string_view fallback;  ///< the default
  std::string_view text;
};

std::span<const OptionEntry> option_table();

/// What -help prints.
std::string help_text(std::string_view program);

}  // namespace ritz::config
