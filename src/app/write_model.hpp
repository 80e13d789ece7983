// The pipeline's results as one file.
#pragma once
#include "ritz/app/geometry.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::app {

/// Throws InputError on all ranks when a file cannot be made where `output` says. *Collective*.
void refuse_unwritable(MPI_Comm comm, const std::filesystem::path& output);

/// Writes the model and, beside it, frequencies.csv. `u`: the modes over owned vertices. *Collective*.
void write_model(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                 const std::vector<fem::StVK>& materials, const FileOrder& order, const petsc::Tall& u,
                 const stages::ModesResult& modes, const model::Inertia& inertia,
                 const std::vector<model::SetLoad>& loads, const Progress& progress);

}  // namespace ritz::app
