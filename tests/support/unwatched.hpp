// Start of MPI in a program that looks for leaks. RITZ_ADDRESS_SANITIZER says that it does, with any compiler.
#pragma once
#ifdef __SANITIZE_ADDRESS__
#define RITZ_ADDRESS_SANITIZER
#elif defined(__has_feature)  // Clang's way to say it
#if __has_feature(address_sanitizer)
#define RITZ_ADDRESS_SANITIZER
#endif
#endif
#ifdef RITZ_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace ritz::test {

/// What start() returns. Memory that it allocates is never called a leak: what Open MPI's plugins lose while they are
/// tried out is theirs, and by the time of a search they are unloaded and have no name that could be suppressed.
template <class Start>
auto unwatched(Start start) {
#ifdef RITZ_ADDRESS_SANITIZER
  const __lsan::ScopedDisabler disabled;
#endif
  return start();
}

}  // namespace ritz::test
