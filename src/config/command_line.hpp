// The words after the program's name, and the options files that they name.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

enum class Asked { run, help };

struct CommandLine {
  Asked asked = Asked::run;
  Given given;
  std::vector<std::filesystem::path> files;  ///< of options
};

/// Refuses words that are neither options nor their values, and reads every -options_file (.yml and .yaml: YAML). The
/// command line wins over files, a file over those after it, a line over those before it. Throws InputError.
/// *Collective*.
CommandLine read_command_line(MPI_Comm comm, int argc, char** argv);

}  // namespace ritz::config
