// A model's report: what a run cost and came to, under the names that figures have in the file.
#pragma once
#include "ritz/app/progress.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

/// *Collective*.
model::Report report(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Results& results, const Progress& progress);

/// What an earlier report says of the basis; absent what it does not say.
BasisFigures basis_figures(const model::Report& report);

/// Iterations of the eigensolver; 0 where the report does not say.
int eigensolver_iterations(const model::Report& report);

}  // namespace ritz::app
