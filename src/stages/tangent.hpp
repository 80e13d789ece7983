// The stiffness of the full model at any displacement.
#pragma once
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/block_rows.hpp"

namespace ritz::stages {

/// A matrix with K's pattern, whose values are computed anew as often as wanted.
struct Tangent {
  BlockPattern pattern;
  petsc::Matrix matrix;  ///< zeros at first
};

/// *Collective*.
Tangent empty_tangent(const Problem& problem);

/// tangent.matrix = Σ_j w_j K(u_j), N/m over the free degrees of freedom, with K = d²E/du² by the elements' own rule
/// and u_j the columns of `u` (m, rows of owned vertices, 3 a vertex). K(0) is assemble's stiffness. Each rank sums its
/// complete rows from its own and its halo's cells, in the file's order: nothing but u at ghosts is communicated, and
/// nothing is allocated in the matrix. *Collective*.
void fill_tangent(Tangent& tangent, const Problem& problem, const Eigen::VectorXd& weights, mesh::VertexRef u);

}  // namespace ritz::stages
