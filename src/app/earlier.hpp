// -reuse: what this run takes from the model of an earlier run of the same problem.
#pragma once
#include <optional>

#include "ritz/algebra/multivector.hpp"
#include "ritz/app/progress.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/config/config.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::app {

/// A basis as stored in a model, and the figures of the modes from which it was made, whose vectors are not stored.
struct FinishedBasis {
  stages::ModesResult modes;
  Eigen::VectorXd mesh_errors;  ///< by mode; empty if none were estimated
  ReducedBasis reduced;
};

struct Earlier {
  mesh::FreeRows modes;  ///< flexible modes to start from, over free degrees of freedom; or no columns
  std::optional<FinishedBasis> basis;
};

/// *Collective*. What the model named by -reuse provides, if its mesh, materials and supports have the same checksums:
/// its modes, if it is linear; its basis, if it was made with the options of this run. Otherwise nothing, and a warning
/// that says why. Throws InputError for a file that is not a model.
Earlier reuse(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
              const fem::Materials& materials, const stages::ModesOptions& options, Progress& progress);

}  // namespace ritz::app
