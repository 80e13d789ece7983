#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/program.hpp"

namespace ritz::tools {
namespace {

void refuse_extras(const CLI::App& app) {
  for (const auto& extra : app.remaining()) {
    if (extra.empty() || extra[0] != '-') throw InputError("unexpected argument '" + extra + "'; see --help");
    std::vector<std::string> known;
    for (const auto* option : app.get_options())
      known.insert(known.end(), option->get_lnames().begin(), option->get_lnames().end());
    const auto word = extra.substr(std::min(extra.find_first_not_of('-'), extra.size()));
    const auto guessed = guess(word, known, [](const std::string& name) { return "'--" + name + "'"; });
    throw InputError("unknown option '" + extra + "'" + (guessed.empty() ? "; see --help" : guessed));
  }
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + "; see --help";
}

}  // namespace

void parse(CLI::App& app, int argc, const char* const* argv) {
  app.allow_extras();
  app.set_version_flag("--version", app.get_name() + " " + version, "Print the version of this program and exit");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw;
  } catch (const CLI::CallForVersion&) {
    throw;
  } catch (const CLI::ParseError& error) {
    refuse_extras(app);  // a misspelt option explains a missing one
    throw InputError(one_line(error.what()));
  }
  refuse_extras(app);
}

}  // namespace ritz::tools
