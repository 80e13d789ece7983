#include "collective.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ritz::format {

std::uint64_t sum(const Access& access, std::uint64_t value) { return access.sum ? access.sum(value) : value; }

std::uint64_t shared(const Access& access, std::uint64_t value) { return sum(access, access.writes_small ? value : 0); }

std::string shared(const Access& access, std::string bytes) {
  if (!access.sum) return bytes;
  bytes.resize(shared(access, bytes.size()));
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    const auto length = std::min(bytes.size() - at, sizeof(std::uint64_t));
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, length);
    word = shared(access, word);
    std::memcpy(bytes.data() + at, &word, length);
  }
  return bytes;
}

Vote vote(const Access& access, bool yes) {
  if (access.vote) return access.vote(yes);
  return yes ? Vote::all_yes : Vote::some_no;
}

void agree(const ModelWriter& out, bool ok, const std::string& path) {
  if (vote(out.access(), ok) == Vote::all_yes) return;
  throw std::runtime_error("cannot write " + path + " of " + out.path().string() +
                           ": is the disk full? No file was left behind; make room and run again");
}

}  // namespace ritz::format
