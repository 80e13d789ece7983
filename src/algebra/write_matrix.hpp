// Writes matrices in formats of other programs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

enum class MatrixFormat { matrixmarket, petsc_binary };

/// *Collective*. Writes A with its rows and columns in the order `order`, of which each rank passes its share as old
/// global numbers. Numbers in text have the shortest digits that are read back as the same double. Throws
/// NumericalError on all ranks when the disk does not take the file.
void write_matrix(const std::filesystem::path& path, Mat A, const std::vector<std::int64_t>& order,
                  MatrixFormat format);

/// *Collective*. Writes a tall matrix as a dense one, with its rows in that order. Throws as above.
void write_columns(const std::filesystem::path& path, MPI_Comm comm, Tall columns,
                   const std::vector<std::int64_t>& order, MatrixFormat format);

}  // namespace ritz::algebra
