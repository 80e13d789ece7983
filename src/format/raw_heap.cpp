#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <set>

#include "raw_header.hpp"

// After the HDF5 file format specification, version 3.0, parts III.E and VII.A.

namespace ritz::format {

namespace {

using Bytes = std::span<const unsigned char>;

/// Jenkins' lookup3, which HDF5 checks its records with.
class Lookup3 {
 public:
  std::uint32_t operator()(Bytes bytes) {
    a_ = b_ = c_ = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size());
    constexpr std::size_t block = 12;
    for (; bytes.size() > block; bytes = bytes.subspan(block)) {
      add(bytes.first(block));
      mix();
    }
    if (bytes.empty()) return c_;
    add(bytes);
    finish();
    return c_;
  }

 private:
  void add(Bytes bytes) {
    std::array<unsigned char, 12> block{};
    std::ranges::copy(bytes, block.begin());
    Cursor in(block);
    for (std::uint32_t* part : {&a_, &b_, &c_}) *part += static_cast<std::uint32_t>(in.number(4));
  }

  void mix() {
    const auto step = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t& z, int bits) {
      x = (x - z) ^ std::rotl(z, bits);
      z += y;
    };
    step(a_, b_, c_, 4);
    step(b_, c_, a_, 6);
    step(c_, a_, b_, 8);
    step(a_, b_, c_, 16);
    step(b_, c_, a_, 19);
    step(c_, a_, b_, 4);
  }

  void finish() {
    const auto step = [](std::uint32_t& x, std::uint32_t y, int bits) { x = (x ^ y) - std::rotl(y, bits); };
    step(c_, b_, 14);
    step(a_, c_, 11);
    step(b_, a_, 25);
    step(c_, b_, 16);
    step(a_, c_, 4);
    step(b_, a_, 14);
    step(c_, b_, 24);
  }

  std::uint32_t a_ = 0, b_ = 0, c_ = 0;
};

/// The object `wanted` of a collection whose objects, and the free space after them, are just what it has room for.
std::optional<Bytes> find_object(Cursor objects, std::uint32_t wanted) {
  constexpr std::size_t head = 16, unit = 8;
  std::set<std::uint64_t> seen;
  std::optional<Bytes> found;
  while (objects.size() >= head) {
    const auto index = objects.number(2);
    objects.take(6);
    const auto bytes = objects.number(8);
    if (!seen.insert(index).second) return {};
    if (index == 0) return bytes == objects.size() + head ? found : std::nullopt;  // what is left is free
    if (bytes > objects.size()) return {};
    const auto object = objects.take(bytes);
    objects.take(std::min<std::size_t>(objects.size(), (unit - bytes % unit) % unit));
    if (index == wanted) found = object;
  }
  return found;
}

bool has_its_checksum(Bytes mapping) {
  constexpr std::size_t width = 4;
  if (mapping.size() < width) return false;
  return Cursor(mapping.last(width)).number(width) == Lookup3{}(mapping.first(mapping.size() - width));
}

}  // namespace

bool sound_mapping(const RawFile& file, std::uint64_t address, std::uint32_t index) try {
  constexpr std::size_t head = 16;
  const auto start = file.bytes(address, head);
  if (std::memcmp(start.data(), "GCOL\1", 5) != 0) return false;
  const auto size = Cursor(std::span(start).subspan(8)).number(8);
  if (index == 0 || size < head) return false;
  const auto collection = file.bytes(address, size);
  const auto mapping = find_object(Cursor(std::span(collection).subspan(head)), index);
  return mapping && has_its_checksum(*mapping);
} catch (const BadHeader&) {
  return false;
}

}  // namespace ritz::format
