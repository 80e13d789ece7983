#include "ritz/format/checksum.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "ritz/base/random.hpp"

namespace ritz::format {

static_assert(std::endian::native == std::endian::little, "the file and its checksums are little-endian");

namespace {

std::uint64_t hash_row(std::uint64_t row, std::span<const std::byte> bytes) {
  std::uint64_t hash = split_mix(row);
  while (!bytes.empty()) {
    const auto length = std::min<std::size_t>(bytes.size(), sizeof(std::uint64_t));
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), length);
    hash = split_mix(hash ^ word);
    bytes = bytes.subspan(length);
  }
  return hash;
}

}  // namespace

std::uint64_t checksum(std::span<const std::byte> bytes, std::size_t row_bytes, std::int64_t first_row) {
  if (row_bytes == 0) return 0;
  std::uint64_t sum = 0;
  auto row = static_cast<std::uint64_t>(first_row);
  for (; !bytes.empty(); bytes = bytes.subspan(row_bytes)) sum += hash_row(row++, bytes.first(row_bytes));
  return sum;
}

}  // namespace ritz::format
