// The report of a model: the cost and the results of the run, under the names that they have in the file.
#pragma once
#include "ritz/app/progress.hpp"
#include "ritz/app/write_model.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

/// *Collective*. Makes the report.
model::Report report(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Results& results, const Progress& progress);

/// The figures of the basis in an earlier report; those that it lacks are absent.
BasisFigures basis_figures(const model::Report& report);

/// The iterations of the eigensolver; 0 if the report lacks them.
int eigensolver_iterations(const model::Report& report);

}  // namespace ritz::app
