// -reuse: modes of an earlier run of the same problem.
#pragma once
#include "ritz/app/progress.hpp"
#include "ritz/config/config.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::app {

/// The flexible modes of the model that -reuse names, over free degrees of freedom, where its mesh, materials and
/// supports have the same checksums; no columns otherwise, with a warning that says why. Throws InputError for a file
/// that is no model. *Collective*.
petsc::Tall modes_to_reuse(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                           const std::vector<fem::StVK>& materials, Progress& progress);

}  // namespace ritz::app
