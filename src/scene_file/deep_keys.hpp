// Refuses keys with so many parts that a recursive parser would run out of stack.
#pragma once
#include <string>

namespace ritz::scene {

/// Throws InputError, with file and line, when a key or a table heading of the TOML text has more parts than any key of
/// a scene needs. The parser itself limits nested arrays and inline tables.
void refuse_deep_keys(const std::string& text, const std::string& file);

}  // namespace ritz::scene
