#include "collective.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>

#include "hdf5.hpp"
#include "ritz/files/part_file.hpp"

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

namespace {

/// Whether a limit on the address space of this process was all but reached, which neither HDF5 nor MPI's files tell
/// of.
bool memory_ran_out() {
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return false;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (rlim_t kilobytes = 0; word == "VmPeak:" && status >> kilobytes)
      return kilobytes * 1024 > space.rlim_cur - space.rlim_cur / 16;
  return false;
}

}  // namespace

void agree(const ModelWriter& out, bool ok, const std::string& path) {
  if (vote(out.access(), ok) == Vote::all_yes) return;
  if (const int error = hdf5_error(); !ok && error != 0) files::fail_to_write(out.path(), error);
  if (!ok && memory_ran_out()) throw std::bad_alloc();
  throw std::runtime_error("cannot write " + path + " of " + out.path().string() +
                           ": is the disk full? No file was left behind; make room and run again");
}

void on_writer(const ModelWriter& out, const std::function<void()>& work) {
  std::exception_ptr failed;
  if (out.access().writes_small) {
    try {
      work();
    } catch (...) {
      failed = std::current_exception();
    }
  }
  if (vote(out.access(), !failed) == Vote::all_yes) return;
  if (failed) std::rethrow_exception(failed);
  throw std::runtime_error("cannot write " + out.path().string() + ": the rank that writes it failed");
}

}  // namespace ritz::format
