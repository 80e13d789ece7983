// The full model's internal force at any displacement.
#pragma once
#include <vector>

#include "ritz/petsc/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// Energies and internal forces of the full model.
struct InternalForces {
  Eigen::VectorXd energies;  ///< J, of the whole body, one a column
  mesh::VertexRows forces;   ///< dE/du, N, rows of owned vertices, 3 a vertex, at fixed components too
};

/// By the elements' own rule, for each column of `u` (m, rows of owned vertices, 3 a vertex). Each rank sums the
/// complete rows of its vertices from its own and its halo's cells, in the file's order. *Collective*.
InternalForces internal_forces(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
