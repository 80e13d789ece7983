// Makes names from files safe to print on a terminal.
#pragma once
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

namespace ritz {

/// The length in bytes of the first UTF-8 character of `text`, which is not empty; 0 if it is not valid (overlong forms
/// and surrogates are not).
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  if (length < 3) return length;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool beyond = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || beyond ? 0 : length;
}

/// The text on one line and without effect on a terminal: control characters (C0, delete, C1) and bytes that are not
/// UTF-8 are written as \xNN; all other characters are unchanged.
inline std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    const bool control =
        first < 0x20 || first == 0x7f || (first == 0xc2 && length == 2 && static_cast<unsigned char>(text[1]) < 0xa0);
    const auto taken = std::max<std::size_t>(length, 1);
    if (length > 0 && !control) shown += text.substr(0, taken);
    else
      for (const char c : text.substr(0, taken)) {
        std::array<char, 5> code{};
        std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
        shown += code.data();
      }
    text.remove_prefix(taken);
  }
  return shown;
}

}  // namespace ritz
