#include "support/allocations.hpp"

#include <cstdlib>

namespace {

thread_local std::size_t count = 0;

}  // namespace

#ifndef __SANITIZE_ADDRESS__
// glibc's own functions, under the names that a program may replace.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t items, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t items, std::size_t size) noexcept {
  ++count;
  return __libc_calloc(items, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  ++count;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++count;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace ritz::test {

std::size_t allocations() { return count; }

bool counts_allocations() {
  const auto before = allocations();
  std::free(std::malloc(1));
  return allocations() > before;
}

}  // namespace ritz::test
