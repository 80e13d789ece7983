// ritz-inspect: what is in a model. See --help.
#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <optional>

#include "command_line.hpp"
#include "inspect.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/format/library.hpp"

namespace {

int fail(int code, const std::string& message) {
  std::cerr << "ritz-inspect: " << ritz::printable(message) << '\n';
  return code;
}

/// What was said must have arrived: a script may act on it.
int said() {
  if (std::cout.flush()) return ritz::exit_done;
  return fail(ritz::exit_numerical, "standard output could not be written: is it closed, or the disk full?");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ritz;
  format::silence_library();
  CLI::App app("Says what is in a reduced model: parts, frequencies, inertia, where it came from.", "ritz-inspect");
  std::filesystem::path path, summary;
  bool check = false;
  Voice voice = Voice::normal;
  app.add_option("model", path, "The model file, as ritz-reduce wrote it")->required();
  app.add_flag("--check", check, "Verify checksums and invariants instead; exit code 2 when one fails");
  app.add_flag_callback(
      "--verbose", [&] { voice = Voice::verbose; },
      "Say also residuals, participation factors, checksums, versions, all figures of the report, datasets");
  app.add_option("--summary", summary, "Write what is in it, as numbers: docs/summary.md")->type_name("FILE.json");
  try {
    tools::parse(app, argc, argv);
    std::optional<files::Claim> claim;
    if (!summary.empty()) {
      files::watch_interruptions("ritz-inspect");
      claim.emplace(tools::claim_summary(summary, path));
    }
    const format::ModelReader in(path);
    std::optional<std::vector<tools::CheckedBody>> checked;
    if (check) checked = tools::check(in, std::cout);
    else tools::describe(in, voice, std::cout);
    if (claim) tools::write_summary(tools::summary(in, checked), summary, *claim);
    return said();
  } catch (const CLI::Success& asked) {  // --help or --version
    app.exit(asked);
    return said();
  } catch (const InputError& error) {
    return fail(exit_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(exit_numerical, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(exit_numerical, error.what());
  }
}
