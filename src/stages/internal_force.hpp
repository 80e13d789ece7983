// The energy, the internal force and the tangent stiffness of the full model at any displacement.
#pragma once
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/sparsity.hpp"

namespace ritz::stages {

/// Energies and internal forces of the full model.
struct InternalForces {
  Eigen::VectorXd energies;  ///< of the whole body, J, one for each column
  mesh::VertexRows forces;   ///< dE/du, N, rows of owned vertices, 3 for each, fixed components included
};

/// *Collective*. Energy and force by the elements' rules and the laws of `materials`, one a region, for each column of
/// `u` (m, rows of owned vertices, 3 for each). Each rank sums the complete rows of its vertices from its own cells and
/// the halo, in the order of the file.
InternalForces internal_forces(const mesh::Mesh& mesh, const fem::Materials& materials, mesh::VertexRef u);

/// A matrix with the pattern of K, whose values can be computed repeatedly.
struct Tangent {
  BlockPattern pattern;
  algebra::Matrix matrix;  ///< zeros at first
};

/// *Collective*. Makes the matrix, filled with zeros.
Tangent empty_tangent(const Problem& problem);

/// *Collective*. tangent.matrix = Σ_j w_j K(u_j), N/m over the free degrees of freedom, where K = d²E/du² by the
/// elements' rules and u_j are the columns of `u` (m, rows of owned vertices, 3 for each). K(0) is the stiffness of
/// assemble. Each rank sums its complete rows from its own cells and the halo, in the order of the file: only u at
/// ghosts is communicated, and nothing is allocated in the matrix.
void fill_tangent(Tangent& tangent, const Problem& problem, const Eigen::VectorXd& weights, mesh::VertexRef u);

/// *Collective*. uᵀKu of each column, J, which is twice the strain energy: ∫ ε : C : ε by the element's rule. As a sum
/// of squares of strains its relative rounding error does not grow with the condition number of K, unlike that of a
/// product with K; slender bodies and fine meshes keep the digits of their low eigenvalues. `u`: rows of owned
/// vertices, 3 for each, m.
Eigen::VectorXd strain_energies(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
