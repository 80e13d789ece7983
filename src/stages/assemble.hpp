// The full model: a mesh, its degrees of freedom, its materials and its sparse matrices.
#pragma once
#include <vector>

#include "ritz/algebra/handle.hpp"
#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/mesh.hpp"

namespace ritz::stages {

/// K (N/m) and M (kg) over the free degrees of freedom, and the scalar consistent mass M_s (kg) over all vertices:
/// M = M_s ⊗ I₃ without the fixed rows and columns.
struct Matrices {
  algebra::Matrix stiffness;
  algebra::Matrix mass;
  algebra::Matrix scalar_mass;
};

/// The unreduced body. Every stage reads it, and none changes it.
struct Problem {
  mesh::Mesh mesh;
  mesh::Dofs dofs;
  fem::Materials materials;
  Matrices matrices;
};

/// *Collective*. Assembles K at rest and the exact consistent mass. Each rank computes the complete rows of its own
/// vertices from its own cells and the halo, in the order of cells in the file: no value is communicated, and no entry
/// depends on the number of ranks. Throws NumericalError when K, M or their quotient is beyond 1e±120.
Problem assemble(mesh::Mesh mesh, mesh::Dofs dofs, fem::Materials materials);

}  // namespace ritz::stages
