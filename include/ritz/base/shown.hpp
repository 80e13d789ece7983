// Numbers and counts as text, for messages.
#pragma once
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace ritz {

/// The text that printf would print.
[[gnu::format(printf, 1, 2)]] inline std::string formatted(const char* format, ...) {
  va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return text;
}

/// The number with `digits` significant digits, and with an exponent where that is shorter: 0.1, 1.6e-06.
inline std::string shown(double x, int digits = 6) { return formatted("%.*g", digits, x); }

/// "1 vertex", "2 vertices".
inline std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

}  // namespace ritz
