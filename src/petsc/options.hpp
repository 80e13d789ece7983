// PETSc's options database as words; typed reading is in the config layer.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ritz::petsc {

/// Adds an options file (.yml and .yaml: YAML; else an option a line, in words and quotes as a shell reads them); what
/// is already set wins over it. Throws InputError. *Collective*.
void insert_options_file(MPI_Comm comm, const std::filesystem::path& file);

/// The value of option `name` (with its dash), empty where it stands alone; marks it as read.
std::optional<std::string> option_value(const std::string& name);

/// Options that nobody has read so far, without their dash, and their values.
std::vector<std::pair<std::string, std::string>> unread_options();

/// Lets the factorization, or the multigrid, under `prefix` read its options on a tiny matrix, so that they count as
/// read. *Collective*.
void read_factorization_options(MPI_Comm comm, const std::string& prefix);
void read_multigrid_options(MPI_Comm comm, const std::string& prefix);

}  // namespace ritz::petsc
