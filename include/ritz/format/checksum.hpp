// The checksum of a dataset: a sum over its rows, so that ranks that hold some rows each can add their shares.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace ritz::format {

/// Σ_i h(first_row + i, bytes of row i) modulo 2^64, with h chained SplitMix64 over the row number and the row's
/// little-endian 8-byte words (the last one padded with zeros). `bytes` holds whole rows of `row_bytes` each; no rows
/// give 0. It finds damage, not forgery.
std::uint64_t checksum(std::span<const std::byte> bytes, std::size_t row_bytes, std::int64_t first_row = 0);

}  // namespace ritz::format
