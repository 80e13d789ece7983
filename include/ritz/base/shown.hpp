// Formats numbers for messages.
#pragma once
#include <cstdarg>
#include <cstdio>
#include <string>

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

}  // namespace ritz
