// Warnings before a long run.
#pragma once
#include <string>
#include <vector>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// *Collective*. The mesh's own warnings, locking of linear tetrahedra, units that look mixed up, a body without
/// supports although the user did not ask for a free one, a slow BLAS; one sentence each.
std::vector<std::string> warnings(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const fem::Materials& materials);

}  // namespace ritz::app
