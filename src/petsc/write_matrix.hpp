// Matrices as files of other programs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

enum class MatrixFormat { matrixmarket, petsc_binary };

/// Writes A with rows and columns in the order of `order` (this rank's share of the new order, as old global numbers).
/// Text has the shortest digits that give the same numbers again. Throws NumericalError on all ranks. *Collective*.
void write_matrix(const std::filesystem::path& path, Mat A, const std::vector<std::int64_t>& order,
                  MatrixFormat format);

/// Writes a tall matrix, dense, with its rows in that order. *Collective*.
void write_columns(const std::filesystem::path& path, MPI_Comm comm, Tall columns,
                   const std::vector<std::int64_t>& order, MatrixFormat format);

}  // namespace ritz::petsc
