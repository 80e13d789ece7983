// Passes options on to the solvers of PETSc and SLEPc.
#pragma once
#include <mpi.h>

#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

/// Whether an option makes SLEPc compute the modes.
bool is_slepc(const Option& option);

/// The options that solvers read themselves, as given. Throws InputError for those that they would read but that ritz
/// does not support.
std::vector<Option> solver_options_given(const Given& given);

/// *Collective*. Passes all options that have not been read to the solvers they belong to, and checks all of them
/// before any report is requested. Returns the reports that go to files, each with its file. Throws InputError for the
/// first option that nobody reads, naming the nearest existing one.
std::vector<Option> hand_to_solvers(MPI_Comm comm, Given& given);

}  // namespace ritz::config
