// Numbers as people read them.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ritz::tools {

std::string grouped(std::int64_t number);                          ///< 50 625
std::string byte_size(std::uint64_t bytes);                        ///< 21.6 kB
std::string duration(double seconds);                              ///< 0.25 s, 12.3 s, 4 min 10 s
std::string shape_text(const std::vector<std::int64_t>& lengths);  ///< 12 x 2
/// Padded with spaces on the right to so many characters (of UTF-8).
std::string padded(std::string text, std::size_t width);

}  // namespace ritz::tools
