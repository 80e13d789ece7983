// The tangent stiffness of the full model at any displacement.
#pragma once
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/block_rows.hpp"

namespace ritz::stages {

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

}  // namespace ritz::stages
