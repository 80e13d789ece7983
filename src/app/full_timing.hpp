// What each step of ritz-full cost, as a table: -timing FILE.csv, with the columns of ritz-run's --timing.
#pragma once
#include <chrono>
#include <cstdint>

#include "ritz/app/pending_file.hpp"

namespace ritz::app {

/// Since the run began.
struct Effort {
  std::int64_t iterations = 0;  ///< Newton's
  std::int64_t rejected = 0;    ///< steps, or increments of the load, that did not converge and were halved
};

/// Times steps by rank 0's clock: all ranks end a step together.
class FullTiming {
 public:
  FullTiming(MPI_Comm comm, const std::filesystem::path& path) : file_(comm, path) {}

  void begin_step();
  /// `t` of the state reached, s (statics: the load fraction).
  void end_step(double t, const Effort& so_far);

  void finish() const;                 ///< Writes the table. *Collective*.
  void publish() { file_.publish(); }  ///< *Collective*.

 private:
  PendingFile file_;
  std::string rows_ = "t,microseconds,iterations,rejected\n";
  Effort before_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace ritz::app
