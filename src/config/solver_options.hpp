// The options of PETSc and SLEPc that are passed on to them: only those named here, because others can run commands,
// load libraries or write files.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

enum class SolverOption {
  setting,  ///< a number or a word, read where a solver is made
  report,   ///< a report of what a solver did, to stdout or a file
  mark      ///< a report at the end of the run; the option has no value
};

/// The kind of a solver option; nothing if it is not passed on.
std::optional<SolverOption> solver_option(const std::string& name);

/// The names of all options that are passed on, for suggestions.
const std::vector<std::string>& solver_option_names();

/// Throws InputError when the value of a setting is neither a number nor a word, or names a solver that is not allowed.
void check_setting(const Option& option);

/// Where a report goes, and the name that PETSc's viewers have for that.
struct Report {
  std::filesystem::path file;  ///< empty: stdout
  std::string format;          ///< PETSc's name of the format; empty: the default
  std::string viewer;
};

/// Parses "", "stdout", "ascii", ":FILE" or "ascii:FILE:FORMAT[:append]". FORMAT is one of `formats`; FILE is a plain
/// name, because PETSc passes some names to a shell. Throws InputError for anything else.
Report parse_report(const Option& option, const std::vector<std::string>& formats);

}  // namespace ritz::config
