// What a careful user is told before a long run.
#pragma once
#include <string>
#include <vector>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// The mesh's own warnings, locking of linear tetrahedra, units that look mixed up, a body that nothing holds though
/// nobody asked for a free one, a slow BLAS. *Collective*.
std::vector<std::string> warnings(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const fem::Materials& materials);

}  // namespace ritz::app
