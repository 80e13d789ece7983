// -snapshots: full displacement vectors from a file.
#pragma once
#include <cstdint>
#include <filesystem>

#include "ritz/mesh/dofs.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::app {

/// The snapshots of a file over free degrees of freedom, m, a column each: NumPy's .npy (float64, C order), or the
/// dataset /snapshots of a file such as ritz-full writes. A snapshot is a row of 3n numbers, x y z of each
/// vertex in the mesh file's order (vertices that no cell uses left out). Throws InputError on all ranks for a file
/// that is not so, vectors of another length, or numbers that are not finite. *Collective*.
mesh::FreeRows read_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh, const mesh::Dofs& dofs);

/// How many snapshots a file holds. Throws InputError on all ranks for what read_snapshots refuses but for the numbers.
/// *Collective*.
std::int64_t count_snapshots(const std::filesystem::path& file, const mesh::Mesh& mesh);

}  // namespace ritz::app
