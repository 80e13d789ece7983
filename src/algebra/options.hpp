// Access to PETSc's options database. Only options of solvers that the config layer admits are put into it.
#pragma once
#include <mpi.h>

#include <string>
#include <vector>

namespace ritz::algebra {

/// Sets option `name` (without its dash); an empty value means an option without a value.
void set_option(const std::string& name, const std::string& value);

/// Removes an option.
void clear_option(const std::string& name);

/// The options that were set but have not been read by any solver, without their dash.
std::vector<std::string> unread_options();

/// How the log of PETSc shows the stages: as flat tables, or nested in one another (the formats ascii_xml and
/// ascii_flamegraph).
enum class Log { flat, nested };

/// Starts the timing of stages.
void begin_log(Log log);

/// *Collective*. Sets a factorization, or multigrid, up on a tiny matrix, so that its options with this prefix count as
/// read.
void read_factorization_options(MPI_Comm comm, const std::string& prefix);
void read_multigrid_options(MPI_Comm comm, const std::string& prefix);

}  // namespace ritz::algebra
