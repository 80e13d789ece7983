// What of the options goes to the solvers of PETSc and SLEPc.
#pragma once
#include <mpi.h>

#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

/// Whether an option hands the modes to SLEPc.
bool is_slepc(const Option& option);

/// The options that solvers read for themselves, as they were given. Throws InputError for what they would read but
/// that ritz does not do.
std::vector<Option> solver_options_given(const Given& given);

/// Hands what nobody has read so far to the solvers, where it is theirs, and checks all of it before any report is
/// asked for. Returns the reports that go to files, each with its file. Throws InputError for the first option that
/// nobody reads, naming the nearest real one. *Collective*.
std::vector<Option> hand_to_solvers(MPI_Comm comm, Given& given);

}  // namespace ritz::config
