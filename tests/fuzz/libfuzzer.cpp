// What libFuzzer calls.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ritz::fuzz::outcome({data, size});
  return 0;
}
