// What makes results independent of the solver and of the number of ranks: pseudo-random vectors that depend on the
// vertex numbers of the mesh file alone, and with them a unique choice of signs and of bases for repeated eigenvalues.
#pragma once
#include <cstdint>
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/mesh/dofs.hpp"

namespace ritz::stages {

/// Columns of numbers in [-1, 1), one for each free degree of freedom, the same on any number of ranks. They start
/// iterations and determine signs.
mesh::FreeRows fixed_vectors(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int columns, std::uint64_t stream);

inline constexpr double cluster_gap = 1e-6;  ///< relative; closer eigenvalues form one cluster, which is never split

/// *Collective*. Rotates the M-orthonormal columns Ψ so that WᵀMΨ has a positive diagonal and, on each group of
/// eigenvalues that agree to 1e-9, is symmetric positive definite (such eigenvalues are so close that any basis of the
/// group has equally small residuals). W is made from vertex numbers of the file (fixed_vectors) and has at least as
/// many columns as the largest group.
void make_canonical(const algebra::Matrix& M, const Eigen::VectorXd& values, const algebra::ConstTallRef& W,
                    algebra::TallRef vectors);

/// The size of the largest such group.
int largest_group(const Eigen::VectorXd& values);

}  // namespace ritz::stages
