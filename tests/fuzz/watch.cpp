#include "fuzz/watch.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

#include "fuzz/target.hpp"

namespace ritz::fuzz {
namespace {

constexpr std::int64_t kilobyte = 1024, spare = 512 * 1024 * kilobyte, times_its_size = 1000;

extern "C" void too_long(int) {
  constexpr std::string_view text = "finding: the input takes too long\n";
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) _exit(1);
  std::abort();
}

/// Of the most memory that the process has had in use.
std::int64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * kilobyte;
}

/// Processor time, so that a busy machine is no finding; 0 stops the clock.
void set_clock(int seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

Watch::Watch(std::string path, int seconds)
    : path_(std::move(path)), file_(open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0644)), seconds_(seconds) {
  if (file_ < 0) throw std::runtime_error("cannot write " + path_);
  std::signal(SIGPROF, too_long);
}

Watch::~Watch() {
  close(file_);
  unlink(path_.c_str());
}

void Watch::begin(std::string_view input) {
  const auto size = static_cast<off_t>(input.size());
  if (ftruncate(file_, size) != 0 || pwrite(file_, input.data(), input.size(), 0) != size)
    throw std::runtime_error("cannot write " + path_);
  peak_ = peak_bytes();
  set_clock(seconds_);
}

void Watch::end(std::string_view input) {
  set_clock(0);
  const auto grown = peak_bytes() - peak_;
  if (grown > spare + times_its_size * static_cast<std::int64_t>(input.size()))
    finding(std::to_string(grown >> 20) + " MB for an input of " + std::to_string(input.size()) + " bytes");
}

}  // namespace ritz::fuzz
