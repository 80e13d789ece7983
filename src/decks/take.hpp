// The scene file of a deck.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ritz/readers/units.hpp"

namespace ritz::decks {

struct Options {
  std::filesystem::path deck;
  std::filesystem::path output;  ///< empty: standard output
  readers::Units units = {};     ///< of the deck's numbers
  readers::Ignored ignored = {};
  std::optional<int> step = {};  ///< from 1; absent: the last that makes a scene
};

struct Taken {
  std::string text;                          ///< of the scene file, in SI units
  std::vector<std::string> notes;            ///< one sentence each; they stand at the head of the text as well
  std::vector<std::filesystem::path> files;  ///< the deck and those it includes
};

/// The scene of a step of a deck (readers/file_scene.hpp says what it is made of). Throws InputError.
Taken take(const Options& options);

}  // namespace ritz::decks
