#include "inspect_text.hpp"

#include <algorithm>
#include <array>

#include "ritz/base/shown.hpp"

namespace ritz::tools {

std::string grouped(std::int64_t number) {
  auto digits = std::to_string(number);
  const std::size_t start = number < 0 ? 1 : 0;
  for (std::size_t at = digits.size(); at > start + 3;) digits.insert(at -= 3, " ");
  return digits;
}

std::string byte_size(std::uint64_t bytes) {
  constexpr std::array units = {"kB", "MB", "GB", "TB"};
  if (bytes < 1000) return std::to_string(bytes) + " B";
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; value >= 999.95 && unit + 1 < units.size(); ++unit) value /= 1000;
  return formatted("%.1f %s", value, units[unit]);
}

std::string duration(double seconds) {
  if (seconds < 100) return formatted("%.3g s", seconds);
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 3600) return formatted("%ld min %ld s", whole / 60, whole % 60);
  return formatted("%ld h %ld min", whole / 3600, whole % 3600 / 60);
}

std::string shape_text(const std::vector<std::int64_t>& lengths) {
  std::string shape;
  for (const auto length : lengths) shape += (shape.empty() ? "" : " x ") + std::to_string(length);
  return shape;
}

std::string padded(std::string text, std::size_t width) {
  const auto characters = static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  if (characters < width) text.append(width - characters, ' ');
  return text;
}

}  // namespace ritz::tools
