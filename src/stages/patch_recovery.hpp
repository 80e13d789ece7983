// Superconvergent patch recovery: what the strains of quadratic tetrahedra lack, from a smoother field through them.
#pragma once
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// *Collective*. For each column of displacements `u` (rows of owned vertices, 3 for each) the energy
/// ∫ (ε* − ε) : C : (ε* − ε), J, over a mesh of Tet10.
///
/// Around each corner a polynomial is fitted to the strains ε at the four points of stiffness of all cells there, where
/// they are most accurate: quadratic from eight cells on, linear with fewer; directions that the points do not
/// determine are left out. The value of ε* at a corner is that of its polynomial, in the middle of an edge the mean of
/// those of both ends; in a cell it is interpolated by the quadratic shape functions. Only cells of similar stiffness
/// (Young's moduli within one octave) are fitted together, because strains jump where the stiffness does.
///
/// Source: O. C. Zienkiewicz and J. Z. Zhu, The superconvergent patch recovery and a posteriori error estimates,
/// International Journal for Numerical Methods in Engineering 33 (1992).
Eigen::VectorXd lacking_energies(const Problem& problem, mesh::VertexRef u);

}  // namespace ritz::stages
