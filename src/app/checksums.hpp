// What a model was computed from, as two short words.
#pragma once
#include <string>
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::app {

struct Checksums {
  std::string mesh;     ///< vertices, cells, regions
  std::string problem;  ///< these, the materials and what is fixed: modes depend on nothing else
};

Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials);

}  // namespace ritz::app
