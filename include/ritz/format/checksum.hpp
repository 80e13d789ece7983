// The checksum of a dataset: a sum over its rows, so that each rank can add the share of the rows that it holds.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace ritz::format {

/// Σ_i h(first_row + i, bytes of row i) modulo 2^64, where h chains SplitMix64 over the row number and the
/// little-endian 8-byte words of the row (the last word padded with zeros). `bytes` holds whole rows of `row_bytes`
/// bytes each; without rows the sum is 0. It detects damage, not forgery.
std::uint64_t checksum(std::span<const std::byte> bytes, std::size_t row_bytes, std::int64_t first_row = 0);

}  // namespace ritz::format
