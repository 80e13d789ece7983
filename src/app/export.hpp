// -export: matrices that other programs read.
#pragma once
#include <filesystem>
#include <vector>

#include "ritz/app/pending_file.hpp"
#include "ritz/config/config.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::app {

/// Where K, M and the modes go, beside the model: MODEL_K.mtx, MODEL_M.mtx, MODEL_modes.mtx (MatrixMarket) or .bin
/// (PETSc). None when nothing is exported.
std::vector<std::filesystem::path> exported_files(const config::Config& config);

/// Writes these. Rows are the free degrees of freedom by vertex in the file's order and component. They are not
/// published yet. *Collective*.
std::vector<PendingFile> export_matrices(const config::Config& config, const stages::Problem& problem,
                                         const petsc::Tall& modes);

}  // namespace ritz::app
