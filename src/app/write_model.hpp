// The pipeline's results as one file.
#pragma once
#include <optional>
#include <vector>

#include "ritz/app/file_geometry.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/pending_file.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/stages/linear_modes.hpp"
#include "ritz/stages/witness.hpp"

namespace ritz::app {

/// What the pipeline came to.
struct Results {
  const stages::ModesResult& modes;
  const petsc::Tall& u;  ///< the basis over owned vertices
  const std::optional<model::Reduction>& reduction;
  const std::optional<model::Polynomial>& polynomial;
  const model::Inertia& inertia;
  const std::vector<model::SetLoad>& loads;
  const stages::Figures& figures;
};

/// Writes the model and, beside it, the table of its frequencies; gives them and what was exported their names.
/// *Collective*.
void write_model(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                 const fem::Materials& materials, const FileGeometry& order, const Results& results,
                 const Progress& progress, const Outputs& outputs, std::vector<PendingFile>& exported);

}  // namespace ritz::app
