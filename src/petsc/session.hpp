// The life of MPI, PETSc and SLEPc: the first local of main, so that it outlives every handle.
#pragma once
#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace ritz::petsc {

class Session {
 public:
  /// Starts MPI, PETSc and SLEPc with no options at all: neither the command line's, nor those of PETSc's own files and
  /// variables, reach them by themselves.
  explicit Session(const std::string& program);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  MPI_Comm comm() const { return MPI_COMM_WORLD; }

  /// What PETSc would have taken options from, in words: "the file .petscrc". As this rank sees it.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  std::vector<std::string> unread_;
};

/// Name and version of each library that a result depends on.
std::vector<std::pair<std::string, std::string>> library_versions();

/// The BLAS that is loaded: "OpenBLAS 0.3.21 ..." or "unknown (the reference BLAS is several times slower)".
std::string loaded_blas();
bool blas_is_openblas();

/// One BLAS thread a rank, unless OPENBLAS_NUM_THREADS or OMP_NUM_THREADS says otherwise.
void limit_blas_threads();

/// The first call of main. OpenBLAS starts its threads when it is loaded, and each maps 128 MB of its own; where the
/// address space is too small for that, they ask for ever, and no end of the program awaits them. So, where there is
/// such a limit (ulimit -v), the program starts itself again with the variables that ask for one thread.
void restart_with_one_blas_thread(char** argv);

/// Has the BLAS take its work space now, which it keeps: 128 MB of address space, of which nothing becomes resident.
/// Where memory runs out in its first call, OpenBLAS would ask again for ever: that there is enough is tried first.
/// Throws std::bad_alloc.
void take_blas_memory();

/// A named stage of -log_view while it lives.
class LogStage {
 public:
  explicit LogStage(const std::string& name);
  ~LogStage();
  LogStage(const LogStage&) = delete;
  LogStage& operator=(const LogStage&) = delete;
};

}  // namespace ritz::petsc
