#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace ritz::tools {

Progress::Progress(std::int64_t steps, Visible visible) : steps_(steps), visible_(visible) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stdout);
  std::fflush(stdout);
}

void Progress::at(std::int64_t step) {
  constexpr std::int64_t seldom = 0x3f;  // asking the clock costs as much as a small step
  if (visible_ == Visible::no || (step & seldom) != 0) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  shown_ = true;
  std::printf("\rstep %lld of %lld (%.0f %%)", static_cast<long long>(step), static_cast<long long>(steps_),
              100 * static_cast<double>(step) / static_cast<double>(steps_));
  std::fflush(stdout);
}

Visible on_terminal() { return isatty(STDOUT_FILENO) != 0 ? Visible::yes : Visible::no; }

}  // namespace ritz::tools
