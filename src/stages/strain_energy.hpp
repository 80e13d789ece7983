// The strain energy of displacement fields, summed over the cells.
#pragma once
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// *Collective*. uᵀKu of each column, J, which is twice the strain energy: ∫ ε : C : ε by the element's rule. As a sum
/// of squares of strains its relative rounding error does not grow with the condition number of K, unlike that of a
/// product with K; slender bodies and fine meshes keep the digits of their low eigenvalues. `u`: rows of owned
/// vertices, 3 for each, m.
Eigen::VectorXd strain_energies(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
