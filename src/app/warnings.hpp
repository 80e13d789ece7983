// What a careful user is told before a long run.
#pragma once
#include <string>
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::app {

/// The mesh's own warnings, locking of linear tetrahedra, a slow BLAS. *Collective*.
std::vector<std::string> warnings(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials);

}  // namespace ritz::app
