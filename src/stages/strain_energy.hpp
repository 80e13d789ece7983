// The energy of displacement fields, summed cell by cell.
#pragma once
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// uᵀKu of each column, J·2: ∫ ε : C : ε by the element's own rule. A sum of squares of strains, so its relative
/// rounding error does not grow with the condition of K as that of the product with K does: slender bodies and fine
/// meshes keep their low eigenvalues' digits. `u`: owned vertices, 3 rows a vertex. *Collective*.
Eigen::VectorXd strain_energies(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
