// Keys of so many parts that a parser which calls itself for each would run out of stack.
#pragma once
#include <string>

namespace ritz::scene {

/// Throws InputError, with file and line, where a key of the TOML text, or a table's heading, has more parts than any
/// key of a scene could need. Nested arrays and inline tables the parser bounds itself.
void refuse_deep_keys(const std::string& text, const std::string& file);

}  // namespace ritz::scene
