#include "deep_keys.hpp"

#include <algorithm>
#include <string_view>

#include "ritz/base/error.hpp"

namespace ritz::scene {
namespace {

constexpr int most_parts = 16;

/// The length of the string that begins at `text`, with its quotes: to the end of the line, or of the text, where it is
/// not closed.
std::size_t string_length(std::string_view text) {
  const char quote = text[0];
  const std::string triple(3, quote);
  const bool long_one = text.starts_with(triple);
  std::size_t i = long_one ? 3 : 1;
  for (; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') ++i;
    else if (long_one ? text.substr(i).starts_with(triple) : text[i] == quote) return i + (long_one ? 3 : 1);
    else if (!long_one && text[i] == '\n') return i;
  }
  return text.size();
}

}  // namespace

void refuse_deep_keys(const std::string& text, const std::string& file) {
  const std::string_view all = text;
  int dots = 0;
  for (std::size_t i = 0; i < all.size();) {
    const char c = all[i];
    if (c == '"' || c == '\'') {
      i += string_length(all.substr(i));
      continue;
    }
    if (c == '#') {
      i = std::min(all.find('\n', i), all.size());
      continue;
    }
    if (c == '.') ++dots;
    else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (dots >= most_parts)
      throw InputError(
          file + ":" +
          std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n')) +
          ": a key has more than " + std::to_string(most_parts) + " parts, and no scene has such a one");
    ++i;
  }
}

}  // namespace ritz::scene
