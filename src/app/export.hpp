// -export: writes the matrices for other programs.
#pragma once
#include <filesystem>
#include <vector>

#include "ritz/app/outputs.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::app {

/// The files beside the model: K, M and the modes, MODEL_K.mtx, MODEL_M.mtx, MODEL_modes.mtx (MatrixMarket) or .bin
/// (PETSc); and MODEL_rows.csv, which says of each of their rows (from 1) whose displacement it is:
/// row,vertex,component, with the mesh file's own number of the vertex and x, y or z. None when nothing is exported.
std::vector<std::filesystem::path> exported_files(const config::Config& config);

/// *Collective*. Writes these files, which the caller publishes. Rows are the free degrees of freedom, ordered by
/// vertex in the mesh file and then by component.
std::vector<PendingFile> export_matrices(const config::Config& config, const stages::Problem& problem,
                                         const algebra::Tall& modes);

}  // namespace ritz::app
