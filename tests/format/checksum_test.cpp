#include "ritz/format/checksum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ritz::format {
namespace {

const std::array<double, 12> numbers = {0, 1, -2, 3.5, 1e300, -0.0, 7, 8, 9, 10, 11, 12};
const auto bytes = std::as_bytes(std::span(numbers));
constexpr std::size_t row = 3 * sizeof(double);

TEST(Checksum, OfRowsIsTheSumOfItsParts) {
  const auto whole = checksum(bytes, row);
  for (std::size_t cut = 0; cut <= 4; ++cut) {
    const auto below = checksum(bytes.first(cut * row), row, 0);
    const auto above = checksum(bytes.subspan(cut * row), row, static_cast<std::int64_t>(cut));
    EXPECT_EQ(whole, below + above) << cut;
  }
}

TEST(Checksum, OfNothingIsZero) { EXPECT_EQ(checksum({}, row), 0u); }

TEST(Checksum, SeesEverySingleBit) {
  std::vector<std::byte> damaged(bytes.begin(), bytes.end());
  for (std::size_t bit = 0; bit < 8 * damaged.size(); ++bit) {
    const auto mask = static_cast<std::byte>(1u << (bit % 8));
    damaged[bit / 8] ^= mask;
    EXPECT_NE(checksum(damaged, row), checksum(bytes, row)) << bit;
    damaged[bit / 8] ^= mask;
  }
}

TEST(Checksum, SeesTheOrderOfRows) {
  auto swapped = numbers;
  std::swap_ranges(swapped.begin(), swapped.begin() + 3, swapped.begin() + 3);
  EXPECT_NE(checksum(std::as_bytes(std::span(swapped)), row), checksum(bytes, row));
}

TEST(Checksum, TakesRowsThatAreNotWholeWords) {
  const std::array<std::uint8_t, 6> types = {10, 10, 24, 12, 12, 5};
  const auto all = std::as_bytes(std::span(types));
  EXPECT_EQ(checksum(all, 1), checksum(all.first(2), 1) + checksum(all.subspan(2), 1, 2));
  EXPECT_NE(checksum(all, 1), checksum(all, 3));
}

}  // namespace
}  // namespace ritz::format
