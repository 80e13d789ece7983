// The words after the program's name.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <vector>

namespace ritz::config {

enum class Asked { run, help };

/// Refuses words that are neither options nor their values, and loads every -options_file (the command line wins).
/// Throws InputError. *Collective*.
Asked read_command_line(MPI_Comm comm, int argc, char** argv);

/// The files that -options_file names.
std::vector<std::filesystem::path> option_files(int argc, char** argv);

}  // namespace ritz::config
