// ritz-full: the unreduced nonlinear simulation, on any number of ranks.
#include <hdf5.h>

#include <cstdio>

#include "ritz/app/full.hpp"
#include "ritz/app/main_guard.hpp"
#include "ritz/config/command_line.hpp"
#include "ritz/config/option_table.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/session.hpp"

int main(int argc, char** argv) {
  using namespace ritz;
  H5dont_atexit();                              // HDF5 crashes there after a write that failed
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // one sentence of ours instead of HDF5's stack
  const petsc::Session session(argc, argv);
  return app::guarded(session.comm(), "ritz-full", [&] {
    const auto asked = config::read_command_line(session.comm(), argc, argv);
    if (asked == config::Asked::help) {
      if (parallel::rank(session.comm()) == 0) std::fputs(config::help_text("ritz-full").c_str(), stdout);
      return;
    }
    app::simulate(session.comm(), config::read_config(session.comm(), config::Program::full));
  });
}
