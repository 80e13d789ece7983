// One choice of signs and of bases of repeated eigenvalues, whatever computed them.
#pragma once
#include <vector>

#include "ritz/petsc/multivector.hpp"

namespace ritz::stages {

inline constexpr double cluster_gap = 1e-6;  ///< relative; closer eigenvalues are one cluster, never cut

/// Turns the M-orthonormal columns Ψ so that WᵀMΨ has a positive diagonal, and is symmetric positive definite on each
/// group of eigenvalues that agree to 1e-9 (so close that any basis of the group has residuals as small). W is made
/// from file vertex numbers and has at least as many columns as the largest group. *Collective*.
void make_canonical(Mat M, const Eigen::VectorXd& values, const petsc::ConstTallRef& W, petsc::TallRef vectors);

/// The size of the largest such group.
int largest_group(const Eigen::VectorXd& values);

}  // namespace ritz::stages
