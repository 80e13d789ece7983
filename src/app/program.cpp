#include "ritz/app/program.hpp"

#include <cstdio>
#include <new>

#include "ritz/algebra/blas.hpp"
#include "ritz/algebra/options.hpp"
#include "ritz/algebra/session.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/program.hpp"
#include "ritz/config/command_line.hpp"
#include "ritz/config/option_table.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/format/library.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {
namespace {

int answer(MPI_Comm comm, const std::string& program, const char* message, int code) {
  const bool together = parallel::vote(comm, false) != Vote::alone;
  if (!together || parallel::rank(comm) == 0) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", program.c_str(), printable(message).c_str());
    std::fflush(stderr);
  }
  if (!together) MPI_Abort(comm, code);
  return code;
}

std::string version_text(const std::string& program) {
  std::string text = program + " " + version + "\n";
  for (const auto& [library, its] : algebra::library_versions()) text += library + ": " + its + "\n";
  return text;
}

}  // namespace

int guarded(MPI_Comm comm, const std::string& program, const std::function<void()>& work) {
  files::watch_interruptions(program);
  try {
    work();
    MPI_Barrier(comm);
    return exit_done;
  } catch (const InputError& e) {
    return answer(comm, program, e.what(), exit_input);
  } catch (const std::bad_alloc&) {
    return answer(comm, program, "memory ran out; use more ranks or machines, or -solver iterative", exit_numerical);
  } catch (const std::exception& e) {
    return answer(comm, program, e.what(), exit_numerical);
  }
}

int run_program(int argc, char** argv, config::Program program,
                const std::function<void(MPI_Comm, const config::Config&)>& work) {
  algebra::restart_with_fitting_blas(argv);
  const std::string name = program == config::Program::full ? "ritz-full" : "ritz-reduce";
  format::silence_library();
  const algebra::Session session(argv[0]);
  const int code = guarded(session.comm(), name, [&] {
    const auto line = config::read_command_line(session.comm(), argc, argv);
    if (line.asked == config::Asked::help) {
      if (parallel::rank(session.comm()) == 0) std::fputs(config::help_text(program).c_str(), stdout);
      return;
    }
    if (line.asked == config::Asked::version) {
      if (parallel::rank(session.comm()) == 0) std::fputs(version_text(name).c_str(), stdout);
      return;
    }
    algebra::take_blas_memory();
    auto config = config::read_config(session.comm(), line.given, program);
    config.option_files = line.files;
    for (const auto& source : session.unread())
      config.warnings.push_back("options of PETSc's own in " + source +
                                " are not read; name a file by -options_file, or delete it");
    work(session.comm(), config);
  });
  if (code == exit_input) algebra::clear_option("log_view");
  return code;
}

}  // namespace ritz::app
