// Faults planted for the test of the drivers (fuzz_test.py).
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fuzz/target.hpp"
#include "ritz/base/error.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
  if (text.starts_with("crash")) std::abort();
  if (text.starts_with("throw")) throw std::runtime_error("some");
  if (text.starts_with("silent")) throw InputError("");
  if (text.starts_with("hang"))
    for (volatile bool goes_on = true; goes_on;) {
    }
  if (text.starts_with("memory")) {
    constexpr std::size_t bytes = 600u << 20;
    std::vector<char> much(bytes, 1);
    if (much[bytes / 2] != 1) throw std::logic_error("memory forgets");
  }
  if (text.starts_with("deep(") && text.find("((((((((((((((((((((") != std::string_view::npos) std::abort();
  if (!text.starts_with("good")) throw InputError("this is not good, byte " + std::to_string(input.size()));
}

}  // namespace ritz::fuzz
