// A line on the terminal that says how far a run has come; nothing where there is no terminal.
#pragma once
#include <chrono>
#include <cstdint>

namespace ritz::tools {

enum class Visible : unsigned char { no, yes };

class Progress {
 public:
  Progress(std::int64_t steps, Visible visible);
  /// Wipes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Writes to stdout at most five times a second.
  void at(std::int64_t step);

 private:
  using Clock = std::chrono::steady_clock;
  std::int64_t steps_;
  Visible visible_;
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(500);
  bool shown_ = false;
};

/// Whether stdout is a terminal.
Visible on_terminal();

}  // namespace ritz::tools
