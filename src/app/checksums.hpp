// What a model was computed from, as two short words.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

model::Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const fem::Materials& materials);

/// Of the bytes of a file that rank 0 reads. Throws InputError when it cannot be read. *Collective*.
std::string file_checksum(MPI_Comm comm, const std::filesystem::path& file);

}  // namespace ritz::app
