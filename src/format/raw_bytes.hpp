// The bytes of a file that HDF5 has opened, and the little-endian numbers in them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "hdf5.hpp"
#include "raw_header.hpp"

namespace ritz::format {

/// Throws BadHeader.
[[noreturn]] void bad_header();

/// A file opened with HDF5's POSIX or in-memory driver.
class RawFile {
 public:
  explicit RawFile(hid_t file);
  std::uint64_t size() const { return size_; }
  /// The bytes [at, at + count). Throws BadHeader when the file does not have them, and for more than 64 MB.
  std::vector<unsigned char> bytes(std::uint64_t at, std::uint64_t count) const;

 private:
  hsize_t size_ = 0;
  const unsigned char* memory_ = nullptr;
  int descriptor_ = -1;
};

/// Reads bytes and numbers one after another. Throws BadHeader past the end.
class Cursor {
 public:
  explicit Cursor(std::span<const unsigned char> bytes) : left_(bytes) {}

  std::size_t size() const { return left_.size(); }
  std::span<const unsigned char> take(std::size_t count);
  std::uint64_t number(std::size_t bytes);

 private:
  std::span<const unsigned char> left_;
};

}  // namespace ritz::format
