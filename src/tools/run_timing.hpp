// What each step cost, as a table: --timing FILE.csv.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>

#include "run_table.hpp"

namespace ritz::tools {

/// A step, or a load step of statics: its load and its solution, without recording.
struct StepCost {
  double t;  ///< s (statics: the load fraction) at its end
  double seconds;
  std::int64_t iterations = 0;  ///< Newton's, of nonlinear models
  std::int64_t rejected = 0;    ///< parts that did not converge and were halved
};

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// t,microseconds,iterations,rejected with a row a step.
class TimingWriter {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TimingWriter(const std::filesystem::path& path);

  void row(const StepCost& step);
  TableFile& table() { return table_; }

 private:
  TableFile table_;
};

}  // namespace ritz::tools
