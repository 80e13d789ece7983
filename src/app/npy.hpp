// The header of a .npy file, as NumPy writes it.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::app {

/// A float64 array of two dimensions in C order: where its numbers stand and how many there are.
struct NpyArray {
  std::int64_t first_byte = 0, rows = 0, columns = 0;
};

/// Throws InputError, named after the option, for a file that is none, holds another kind of array, or is shorter or
/// longer than its shape says.
NpyArray read_npy_header(const std::filesystem::path& file, const std::string& option);

}  // namespace ritz::app
