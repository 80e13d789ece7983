// Counts with the right form of the noun.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ritz {

/// "1 vertex", "2 vertices".
inline std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

}  // namespace ritz
