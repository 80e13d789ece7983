// -export: matrices that other programs read.
#pragma once
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::app {

/// Writes K, M and the modes beside the model, as MODEL_K.mtx, MODEL_M.mtx, MODEL_modes.mtx (MatrixMarket) or .bin
/// (PETSc). Rows are the free degrees of freedom by vertex in the file's order and component. *Collective*.
void export_matrices(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                     const stages::Full& full, const petsc::Tall& modes);

}  // namespace ritz::app
