// The header of a .npy file of NumPy.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::app {

/// Position and shape of a two-dimensional float64 array in C order.
struct NpyArray {
  std::int64_t first_byte = 0, rows = 0, columns = 0;
};

/// Reads the header. Throws an InputError that names the option, for a file that is not a .npy file, holds another kind
/// of array, or is shorter or longer than its shape implies.
NpyArray read_npy_header(const std::filesystem::path& file, const std::string& option);

}  // namespace ritz::app
