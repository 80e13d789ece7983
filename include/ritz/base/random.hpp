// Reproducible random numbers: the same on every machine, with every standard library and number of ranks.
#pragma once
#include <cstdint>

namespace ritz {

/// SplitMix64: a well-mixed 64-bit hash of a counter [Steele, Lea, Flood 2014].
constexpr std::uint64_t split_mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// The random number in [-1, 1) with number `index` in the sequence `stream`.
constexpr double uniform(std::uint64_t stream, std::uint64_t index) {
  const auto bits = split_mix(split_mix(stream) ^ index) >> 11;
  return static_cast<double>(bits) * 0x1p-52 - 1.0;
}

}  // namespace ritz
