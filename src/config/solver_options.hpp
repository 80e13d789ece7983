// The options of PETSc and SLEPc that are passed on to their solvers: only those named in solver_names.cpp, because
// others can run commands, load libraries or write files.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/config/options.hpp"

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

/// All combinations of these prefixes and names; lists are separated by blanks.
struct SolverNames {
  SolverOption kind;
  std::string_view prefixes, names;
  std::string_view words = "";  ///< the only values allowed, if there is a list of them
};

std::span<const SolverNames> solver_names();

/// Whether an option makes SLEPc compute the modes.
bool is_slepc(const Option& option);

/// The options that solvers read themselves, as given. Throws InputError for those that they would read but that ritz
/// does not support.
std::vector<Option> solver_options_given(const Given& given);

/// *Collective*. Passes all options that have not been read to the solvers they belong to, and checks all of them
/// before any report is requested. Returns the reports that go to files, each with its file. Throws InputError for the
/// first option that nobody reads, naming the nearest existing one.
std::vector<Option> hand_to_solvers(MPI_Comm comm, Given& given);

}  // namespace ritz::config
