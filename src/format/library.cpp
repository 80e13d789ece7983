#include "ritz/format/library.hpp"

#include <cstdlib>
#include <cstring>

#include "hdf5.hpp"

namespace ritz::format {
namespace {

/// HDF5 keeps the number in the texts of its stack alone: "file write failed: ..., errno = 28, ...".
extern "C" herr_t find_errno(unsigned, const H5E_error2_t* entry, void* found) {
  constexpr const char* word = "errno = ";
  const char* at = entry->desc ? std::strstr(entry->desc, word) : nullptr;
  if (at) *static_cast<int*>(found) = std::atoi(at + std::strlen(word));
  return 0;
}

}  // namespace

void silence_library() {
  H5dont_atexit();
  silence_errors();
}

void silence_errors() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

int hdf5_error() {
  int found = 0;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_errno, &found);
  return found;
}

}  // namespace ritz::format
