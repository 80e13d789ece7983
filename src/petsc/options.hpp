// What of PETSc's options database ritz fills and asks: options of solvers alone, which the config layer has let
// through.
#pragma once
#include <mpi.h>

#include <string>
#include <vector>

namespace ritz::petsc {

/// Sets option `name` (without its dash); an empty value: it stands alone.
void set_option(const std::string& name, const std::string& value);

/// Takes an option out again.
void clear_option(const std::string& name);

/// Options that were set and that no solver has read so far, without their dash.
std::vector<std::string> unread_options();

/// How -log_view shows the stages: as tables, or nested in one another (the formats ascii_xml and ascii_flamegraph).
enum class Log { flat, nested };

/// Begins to time the stages.
void begin_log(Log log);

/// Lets the factorization, or the multigrid, under `prefix` read its options on a tiny matrix, so that they count as
/// read. *Collective*.
void read_factorization_options(MPI_Comm comm, const std::string& prefix);
void read_multigrid_options(MPI_Comm comm, const std::string& prefix);

}  // namespace ritz::petsc
