// The cost of each step of ritz-full as a table, for -timing FILE.csv; it has the columns of ritz-run's --timing.
#pragma once
#include <chrono>
#include <cstdint>

#include "ritz/app/pending_file.hpp"

namespace ritz::app {

/// The effort since the run began.
struct Effort {
  std::int64_t iterations = 0;  ///< of Newton's method
  std::int64_t rejected = 0;    ///< steps, or load increments, that did not converge and were halved
};

/// Times steps by the clock of rank 0, as all ranks end a step together.
class FullTiming {
 public:
  FullTiming(MPI_Comm comm, const std::filesystem::path& path) : file_(comm, path) {}

  void begin_step();
  /// `t` is the time of the state reached, s (statics: the load fraction).
  void end_step(double t, const Effort& so_far);

  void finish() const;                 ///< *Collective*. Writes the table.
  void publish() { file_.publish(); }  ///< *Collective*. Renames the file to its final name.

 private:
  PendingFile file_;
  std::string rows_ = "t,microseconds,iterations,rejected\n";
  Effort before_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace ritz::app
