// The full model: a mesh, its numbering, its materials and their sparse matrices.
#pragma once
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/petsc/handle.hpp"

namespace ritz::stages {

/// K (N/m) and M (kg) over the free degrees of freedom; M_s, the scalar consistent mass (kg) over all vertices, so that
/// M = M_s ⊗ I₃ less the fixed rows and columns.
struct Matrices {
  petsc::Matrix stiffness;
  petsc::Matrix mass;
  petsc::Matrix scalar_mass;
};

/// The unreduced body. Every stage reads this one value, and none changes it.
struct Problem {
  mesh::Mesh mesh;
  mesh::Dofs dofs;
  fem::Materials materials;
  Matrices matrices;
};

/// Assembles K at rest and the exact consistent mass. Each rank computes the complete rows of its own vertices from its
/// own and its halo's cells, in the file's order of cells: no value is communicated, and no entry depends on the number
/// of ranks. Throws NumericalError for a K or M, or their quotient, beyond 1e±120.
/// *Collective*.
Problem assemble(mesh::Mesh mesh, mesh::Dofs dofs, fem::Materials materials);

}  // namespace ritz::stages
