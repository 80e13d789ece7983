// The internal force of the full model at any displacement.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// Energies and internal forces of the full model.
struct InternalForces {
  Eigen::VectorXd energies;  ///< of the whole body, J, one for each column
  mesh::VertexRows forces;   ///< dE/du, N, rows of owned vertices, 3 for each, fixed components included
};

/// *Collective*. Energy and force by the elements' rules for each column of `u` (m, rows of owned vertices, 3 for
/// each). Each rank sums the complete rows of its vertices from its own cells and the halo, in the order of the file.
InternalForces internal_forces(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
