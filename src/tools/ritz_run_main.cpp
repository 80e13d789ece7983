// ritz-run: the serial runtime. See --help.
#include <iostream>
#include <new>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/format/library.hpp"
#include "run.hpp"

namespace {

int fail(int code, const char* message) {
  std::cerr << "ritz-run: " << ritz::printable(message) << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ritz;
  format::silence_library();
  files::watch_interruptions("ritz-run");
  try {
    const auto parsed = tools::parse_run_options(argc, argv);
    if (const auto* help = std::get_if<tools::Help>(&parsed)) std::cout << help->text;
    else tools::run(std::get<tools::RunOptions>(parsed), std::cout, std::cerr);
    return exit_done;
  } catch (const InputError& error) {
    return fail(exit_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(exit_numerical, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(exit_numerical, error.what());
  }
}
