// What a process keeps an eye on while a target runs: the input itself, its time, its memory.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ritz::fuzz {

/// Writes each input to a file before it is run, so that it is still there when the process is not.
class Watch {
 public:
  /// `path`: the file that is left behind by a finding. Throws std::runtime_error when it cannot be written.
  Watch(std::string path, int seconds);
  /// No finding: the file goes.
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void begin(std::string_view input);
  /// A finding where the input took much more memory than its size explains.
  void end(std::string_view input);

 private:
  std::string path_;
  int file_;
  int seconds_;  ///< of processor time for one input
  std::int64_t peak_ = 0;
};

}  // namespace ritz::fuzz
