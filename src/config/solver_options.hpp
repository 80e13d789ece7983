// The options of PETSc and SLEPc that are let through to them: those named here and no other, for among the rest are
// some that run commands, load libraries and write files.
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
  report,   ///< of what a solver did, to stdout or a file
  mark      ///< to be printed at the end; it stands alone
};

/// What an option is to its solver; nothing where it is not let through.
std::optional<SolverOption> solver_option(const std::string& name);

/// Every name that is let through, for suggestions.
const std::vector<std::string>& solver_option_names();

/// Throws InputError where the value of a setting is no number and no word, or names a solver that is not let through.
void check_setting(const Option& option);

/// Where a report goes, and how PETSc's viewers call that.
struct Report {
  std::filesystem::path file;  ///< empty: stdout
  std::string format;          ///< PETSc's name of the layout; empty: the usual one
  std::string viewer;
};

/// "", "stdout", "ascii", ":FILE", "ascii:FILE:FORMAT[:append]"; FORMAT is one of `formats`, FILE a plain name, for
/// PETSc hands some names to a shell. Throws InputError for anything else.
Report parse_report(const Option& option, const std::vector<std::string>& formats);

}  // namespace ritz::config
