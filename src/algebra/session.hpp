// The lifetime of MPI, PETSc and SLEPc. A session is the first local variable of main, so that it outlives every
// handle.
#pragma once
#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace ritz::algebra {

class Session {
 public:
  /// Starts MPI, PETSc and SLEPc without any options: neither those of the command line nor those of PETSc's own files
  /// and environment variables reach them.
  explicit Session(const std::string& program);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  MPI_Comm comm() const { return MPI_COMM_WORLD; }

  /// The sources from which PETSc would have read options, in words ("the file .petscrc"), as this rank sees them.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  std::vector<std::string> unread_;
};

/// The name and version of each library that results depend on.
std::vector<std::pair<std::string, std::string>> library_versions();

/// The BLAS that is loaded: "OpenBLAS 0.3.21 ..." or "unknown (the reference BLAS is several times slower)".
std::string loaded_blas();
bool blas_is_openblas();

/// Limits the BLAS to one thread on each rank, unless OPENBLAS_NUM_THREADS or OMP_NUM_THREADS says otherwise.
void limit_blas_threads();

/// The first call of main. OpenBLAS starts its threads when it is loaded, and each maps 128 MB; if the address space is
/// too small for that, they retry for ever and cannot be ended with the program. Therefore, if there is a limit (ulimit
/// -v), the program starts itself again with the environment variables that ask for one thread.
void restart_with_one_blas_thread(char** argv);

/// Makes the BLAS allocate its work space now, which it keeps: 128 MB of address space, none of which becomes resident.
/// If memory ran out in its first call, OpenBLAS would retry for ever; so it is checked first that there is enough.
/// Throws std::bad_alloc.
void take_blas_memory();

/// A named stage of PETSc's log, for the lifetime of the object.
class LogStage {
 public:
  explicit LogStage(const std::string& name);
  ~LogStage();
  LogStage(const LogStage&) = delete;
  LogStage& operator=(const LogStage&) = delete;
};

}  // namespace ritz::algebra
