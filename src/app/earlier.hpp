// -reuse: what an earlier run of the same problem gives to this one.
#pragma once
#include <optional>

#include "ritz/app/progress.hpp"
#include "ritz/app/reduced_parts.hpp"
#include "ritz/config/config.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::app {

/// A basis as it stands in a model, and the figures of the modes that it was made from, whose vectors are not stored.
struct FinishedBasis {
  stages::ModesResult modes;
  ReducedBasis reduced;
};

struct Earlier {
  mesh::FreeRows modes;  ///< flexible modes to begin with, over free degrees of freedom; or no columns
  std::optional<FinishedBasis> basis;
};

/// What the model that -reuse names gives, where its mesh, materials and supports have the same checksums: its modes
/// where it is linear; its basis where the options that made it are those of this run. Nothing otherwise, with a
/// warning that says why. Throws InputError for a file that is no model. *Collective*.
Earlier reuse(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
              const fem::Materials& materials, const stages::ModesOptions& options, Progress& progress);

}  // namespace ritz::app
