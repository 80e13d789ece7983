#include "ritz/config/solver_options.hpp"

#include <algorithm>

#include "ritz/algebra/eigensolver.hpp"
#include "ritz/algebra/newton.hpp"
#include "ritz/algebra/options.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/config/option_table.hpp"

namespace ritz::config {
namespace {

constexpr std::size_t longest_name = 100;  ///< that is looked for among the real ones

const std::vector<std::string> formats = {"default", "ascii_info", "ascii_info_detail"};
const std::vector<std::string> no_formats;  ///< of monitors: PETSc crashes over those that it does not expect
const std::vector<std::string> log_formats = {"default",   "ascii_info", "ascii_info_detail",
                                              "ascii_csv", "ascii_xml",  "ascii_flamegraph"};

bool is_own(const std::string& name) {
  const auto names = option_names();
  return std::ranges::find(names, small_letters(name)) != names.end();
}

[[noreturn]] void refuse_unknown(const std::string& name) {
  if (name.size() > longest_name)
    throw InputError("there is no option -" + printable(name.substr(0, longest_name)) + "... (-help lists them all)");
  const auto dashed = [](const std::string& known) { return "-" + known; };
  const auto word = name.substr(std::min(name.find_first_not_of('-'), name.size()));  // of --mesh, too
  const auto equals = word.find('=');
  if (equals != word.npos && is_own(word.substr(0, equals)))
    throw InputError("there is no option -" + printable(name) + ": write -" + printable(word.substr(0, equals)) + " " +
                     printable(word.substr(equals + 1)) + ", with a blank");
  const auto own = nearest(word, option_names()), of_solver = nearest(word, solver_option_names());
  const bool for_solver = is_misspelt(word, of_solver) && edit_distance(word, of_solver) < edit_distance(word, own);
  auto guessed = for_solver ? "" : guess(word, option_names(), dashed);
  if (guessed.empty() && word.find('_') != word.npos) guessed = guess(word, solver_option_names(), dashed);
  throw InputError("there is no option -" + printable(name) + guessed + " (-help lists them all)");
}

/// Settings that solvers read only when they have levels or blocks, which a tiny matrix has not.
bool is_late(const std::string& name) {
  return name.starts_with("modes_st_mg_") || name.starts_with("modes_st_sub_") ||
         name.ends_with("_error_if_not_converged");
}

bool is_monitor(const std::string& name) { return small_letters(name).find("_monitor") != std::string::npos; }

/// The solvers meet their options here first: what they object to is input, whatever they call it.
void read_settings(MPI_Comm comm) {
  try {
    algebra::read_eigensolver_options(comm);
    algebra::read_factorization_options(comm, "solve_");
    algebra::read_multigrid_options(comm, "multigrid_");
    algebra::read_newton_options(comm);
  } catch (const NumericalError& error) {
    const std::string why = error.what();
    throw InputError("an option under -modes_, -solve_, -multigrid_ or -newton_ does not work: " +
                     why.substr(0, why.find(" (in ")));
  }
  for (const auto& name : algebra::unread_options())
    if (!is_late(name)) refuse_unknown(name);
}

/// Asks PETSc for the reports: last, so that no file is opened before all options are known to be right.
std::vector<Option> order(const std::vector<std::pair<std::string, Report>>& reports) {
  std::vector<Option> files;
  for (const auto& [name, report] : reports) {
    if (name == "log_view")
      algebra::begin_log(report.format == "ascii_xml" || report.format == "ascii_flamegraph" ? algebra::Log::nested
                                                                                             : algebra::Log::flat);
    algebra::set_option(name, report.viewer);
    if (!report.file.empty()) files.push_back({name, report.file.string()});
  }
  return files;
}

}  // namespace

bool is_slepc(const Option& option) {
  return option.name.starts_with("modes_eps_") || option.name.starts_with("modes_st_");
}

std::vector<Option> solver_options_given(const Given& given) {
  auto options = given.unread();
  for (auto& option : options) option.name = small_letters(option.name);
  std::erase_if(options, [](const Option& o) {
    return !is_slepc(o) && !o.name.starts_with("modes_bv_") && !o.name.starts_with("modes_ds_") &&
           !o.name.starts_with("solve_") && !o.name.starts_with("multigrid_") && !o.name.starts_with("newton_");
  });
  for (const auto& [name, value] : options) {
    if (name.starts_with("multigrid_mg_"))
      throw InputError("option -" + name + " has no effect: the multigrid has its own smoothers; leave it out");
    if (name == "modes_eps_interval")
      throw InputError("option -" + name + ": modes are sought by number, from the lowest on; give -modes K instead");
  }
  return options;
}

std::vector<Option> hand_to_solvers(MPI_Comm comm, Given& given) {
  std::vector<std::pair<std::string, Report>> reports;
  for (const auto& option : given.unread()) {
    const auto kind = solver_option(option.name);
    if (!kind && !is_own(option.name)) refuse_unknown(option.name);
    if (kind == SolverOption::mark && !option.value.empty())
      throw InputError("option -" + option.name + " stands alone; leave '" + option.value + "' out");
    if (kind == SolverOption::report || kind == SolverOption::mark)
      reports.emplace_back(option.name, parse_report(option, is_monitor(option.name) ? no_formats : formats));
    if (kind != SolverOption::setting) continue;
    check_setting(option);
    algebra::set_option(option.name, option.value);
  }
  if (const auto log = given.read("log_view"))
    reports.emplace_back("log_view", parse_report({"log_view", *log}, log_formats));
  read_settings(comm);
  return order(reports);
}

}  // namespace ritz::config
