// -snapshots: reads full displacement vectors from a file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <istream>
#include <span>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::app {

enum class NpyOrder : std::uint8_t { by_rows, by_columns };  ///< C order, Fortran order

/// Position and shape of a two-dimensional array of floating point numbers.
struct NpyArray {
  std::int64_t first_byte = 0, rows = 0, columns = 0;
  int number_bytes = 8;  ///< 8 of float64, 4 of float32
  NpyOrder order = NpyOrder::by_rows;
};

/// Reads the header. Throws an InputError that names the option, for a file that is not a .npy file, holds another kind
/// of array, or is shorter or longer than its shape implies.
NpyArray read_npy_header(const std::filesystem::path& file, const std::string& option);

/// Reads `into.size()` numbers, as they stand one after another from number `first` on.
void read_npy(std::istream& in, const NpyArray& array, std::int64_t first, std::span<double> into);

/// *Collective*. The snapshots of a file over free degrees of freedom, m, one column for each. The file is a .npy file
/// of NumPy (float64 or float32, in C or Fortran order), or has a dataset /snapshots such as ritz-full writes. A
/// snapshot is a row of 3n numbers: x, y, z of each vertex in the order of the mesh file, without vertices that no cell
/// uses. Throws InputError on all ranks for any other file, for vectors of another length, and for numbers that are not
/// finite.
mesh::FreeRows read_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// *Collective*. The number of snapshots in a file. Throws InputError on all ranks as read_snapshots does, except for
/// numbers, which it does not read.
std::int64_t count_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh);

}  // namespace ritz::app
