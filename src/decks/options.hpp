// The command line of ritz-scene.
#pragma once
#include <string>
#include <variant>

#include "take.hpp"

namespace ritz::decks {

/// What --help or --version print.
struct Help {
  std::string text;
};

/// Throws InputError of one line, which names the nearest option for an unknown one.
std::variant<Options, Help> parse_options(int argc, const char* const* argv);

}  // namespace ritz::decks
