// Small damage to files, in the ways in which people, programs and attackers do it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ritz/base/random.hpp"

namespace ritz::fuzz {

/// Fixed random numbers, one after another.
class Random {
 public:
  explicit Random(std::uint64_t stream) : stream_(split_mix(stream)) {}
  std::uint64_t next() { return split_mix(stream_ ^ counter_++); }
  /// Below `bound`, which is not 0.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(next() % bound); }

 private:
  std::uint64_t stream_, counter_ = 0;
};

/// What mutations draw from.
struct Material {
  std::vector<std::string> words;  ///< of the format
  std::vector<std::string> pool;   ///< inputs to begin with and to splice from; at least one
};

inline constexpr std::size_t most_bytes = 65536;  ///< of a mutated input

/// One of the pool with one to four changes, each of a random kind: bits and bytes, numbers, cuts, splices, words,
/// lines that move, vanish or come again, nested repetition.
std::string mutated(const Material& material, Random& random);

/// The words of a dictionary in libFuzzer's form: `name="word"` or `"word"` a line, with \\, \" and \xNN in it.
/// Throws std::runtime_error when there is no such file or a line is not so.
std::vector<std::string> read_dictionary(const std::string& path);

}  // namespace ritz::fuzz
