// Checksums of what a model is computed from.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

/// The checksums of the mesh, and of the mesh with its materials and supports.
model::Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const fem::Materials& materials);

/// *Collective*. The checksum of the bytes of a file, which rank 0 reads. Throws InputError when it cannot be read.
std::string file_checksum(MPI_Comm comm, const std::filesystem::path& file);

}  // namespace ritz::app
