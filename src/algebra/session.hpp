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

/// A named stage of PETSc's log, for the lifetime of the object.
class LogStage {
 public:
  explicit LogStage(const std::string& name);
  ~LogStage();
  LogStage(const LogStage&) = delete;
  LogStage& operator=(const LogStage&) = delete;
};

}  // namespace ritz::algebra
