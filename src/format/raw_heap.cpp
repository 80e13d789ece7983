#include <cstring>
#include <set>

#include "raw_bytes.hpp"

// After the HDF5 file format specification, version 3.0, part III.E.

namespace ritz::format {

namespace {

bool has_object(Cursor objects, std::uint32_t wanted) {
  constexpr std::size_t head = 16;
  std::set<std::uint64_t> seen;
  while (objects.size() >= head) {
    const auto index = objects.number(2);
    objects.take(6);
    const auto bytes = objects.number(8);
    if (!seen.insert(index).second) return false;
    if (index == 0) return bytes == objects.size() + head && seen.contains(wanted);  // what is left is free
    if (bytes > objects.size()) return false;
    objects.take(std::min<std::size_t>(objects.size(), (bytes + 7) / 8 * 8));
  }
  return seen.contains(wanted);
}

}  // namespace

bool sound_heap(hid_t file, std::uint64_t address, std::uint32_t index) try {
  constexpr std::size_t head = 16;
  const Quiet quiet;
  const RawFile bytes(file);
  const auto start = bytes.bytes(address, head);
  if (std::memcmp(start.data(), "GCOL\1", 5) != 0) return false;
  const auto size = Cursor(std::span(start).subspan(8)).number(8);
  if (size < head) return false;
  const auto collection = bytes.bytes(address, size);
  return index > 0 && has_object(Cursor(std::span(collection).subspan(head)), index);
} catch (const BadHeader&) {
  return false;
}

}  // namespace ritz::format
