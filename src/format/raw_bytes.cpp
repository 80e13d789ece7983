#include "raw_header.hpp"

#include <unistd.h>

#include <algorithm>

namespace ritz::format {

void bad_header() { throw BadHeader("has a damaged header"); }

RawFile::RawFile(hid_t file) {
  const Properties access(H5Fget_access_plist(file));
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file, access.get(), &handle) < 0 || H5Fget_filesize(file, &size_) < 0) bad_header();
  if (H5Pget_driver(access.get()) == H5FD_CORE) memory_ = *static_cast<const unsigned char* const*>(handle);
  else descriptor_ = *static_cast<const int*>(handle);
}

std::vector<unsigned char> RawFile::bytes(std::uint64_t at, std::uint64_t count) const {
  constexpr std::uint64_t most = 1 << 26;
  if (count > most || at > size_ || count > size_ - at) bad_header();
  std::vector<unsigned char> read(count);
  if (memory_ != nullptr) std::copy_n(memory_ + at, count, read.begin());
  else if (::pread(descriptor_, read.data(), count, static_cast<off_t>(at)) != static_cast<ssize_t>(count))
    bad_header();
  return read;
}

std::span<const unsigned char> Cursor::take(std::size_t count) {
  if (count > left_.size()) bad_header();
  const auto taken = left_.first(count);
  left_ = left_.subspan(count);
  return taken;
}

std::uint64_t Cursor::number(std::size_t bytes) {
  std::uint64_t value = 0;
  const auto taken = take(bytes);
  for (std::size_t i = 0; i < bytes; ++i) value |= std::uint64_t{taken[i]} << (8 * i);
  return value;
}

}  // namespace ritz::format
