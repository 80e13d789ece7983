// How often a test asks for memory.
#pragma once
#include <cstddef>

namespace ritz::test {

/// Calls of malloc and its relatives by this thread so far. A sanitizer has its own malloc, where nothing is counted.
std::size_t allocations();
bool counts_allocations();

}  // namespace ritz::test
