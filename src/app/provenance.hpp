// What a model is computed from: the checksums of the mesh, the problem and further files, and the options with their
// final values.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/model/model.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// The checksums of the mesh, and of the mesh with its materials and supports.
model::Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const fem::Materials& materials);

/// *Collective*. The checksum of the bytes of a file, which rank 0 reads. Throws InputError when it cannot be read.
std::string file_checksum(MPI_Comm comm, const std::filesystem::path& file);

using Options = std::vector<std::pair<std::string, std::string>>;

/// *Collective*. All options with their final values: with the solver that was chosen, the supports that apply without
/// -fix, and the checksums of the files of -snapshots and -accuracy_scene.
Options resolved(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy);

/// The value of an option; empty if it is not among these.
std::string value_of(const Options& options, const std::string& name);

}  // namespace ritz::app
