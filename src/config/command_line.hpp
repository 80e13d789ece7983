// The words after the program's name, and the options files that they name.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <vector>

#include "ritz/config/options.hpp"

namespace ritz::config {

enum class Asked { run, help, version };

struct CommandLine {
  Asked asked = Asked::run;
  Given given;
  std::vector<std::filesystem::path> files;  ///< the options files
};

/// *Collective*. Refuses words that are neither options nor their values, and reads every -options_file (.yml and
/// .yaml: as YAML). The command line takes precedence over files, a file over files after it, a line over lines before
/// it. Throws InputError.
CommandLine read_command_line(MPI_Comm comm, int argc, char** argv);

}  // namespace ritz::config
