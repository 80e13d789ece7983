// The sparse matrices of the full model.
#pragma once
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/petsc/handle.hpp"

namespace ritz::stages {

/// K (N/m) and M (kg) over the free degrees of freedom; M_s, the scalar consistent mass (kg) over all vertices, so that
/// M = M_s ⊗ I₃ less the fixed rows and columns.
struct Full {
  std::vector<fem::StVK> materials;  ///< by region
  petsc::Matrix stiffness;
  petsc::Matrix mass;
  petsc::Matrix scalar_mass;
};

/// Assembles K at rest and the exact consistent mass. Each rank computes the complete rows of its own vertices from its
/// own and its halo's cells, in the file's order of cells: no value is communicated, and no entry depends on the number
/// of ranks. `materials` are by region. Throws NumericalError for a K or M, or their quotient, beyond 1e±120.
/// *Collective*.
Full assemble(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials);

}  // namespace ritz::stages
