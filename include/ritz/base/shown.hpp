// Numbers as a message shows them.
#pragma once
#include <cstdio>
#include <string>

namespace ritz {

/// `digits` significant ones, with an exponent where that is shorter: 0.1, 1.6e-06.
inline std::string shown(double x, int digits = 6) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

}  // namespace ritz
