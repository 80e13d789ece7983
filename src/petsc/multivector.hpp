// Tall matrices (distributed rows, few columns) and their products.
#pragma once
#include <Eigen/Core>
#include <functional>

#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// This rank's rows of a tall matrix, column-major; the columns are whole on each rank.
using Tall = Eigen::MatrixXd;
using TallRef = Eigen::Ref<Eigen::MatrixXd>;
using ConstTallRef = Eigen::Ref<const Eigen::MatrixXd>;

/// Lays PETSc vectors that fit A over the columns of x and y, one pair at a time, and calls `op(from, to)` on each.
void apply_to_columns(Mat A, const ConstTallRef& x, TallRef y, const std::function<void(Vec from, Vec to)>& op);

/// y = A x, column by column. *Collective* on A.
void multiply(Mat A, const ConstTallRef& x, TallRef y);
Tall multiply(Mat A, const ConstTallRef& x);

/// xᵀ y (small, the same on all ranks). *Collective*.
Eigen::MatrixXd inner(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& y);

/// Column norms ‖x_j‖₂. *Collective*.
Eigen::VectorXd column_norms(MPI_Comm comm, const ConstTallRef& x);

/// The local rows x (contiguous columns) seen as a dense PETSc matrix; x must outlive it.
Matrix as_dense(MPI_Comm comm, TallRef x);

/// M-orthonormalises x against the M-orthonormal columns of `against` (may have none) and within itself, twice.
/// Directions whose M-norm falls below `drop` times what it was are removed: returns how many columns are left (they
/// stand first). *Collective*.
int orthonormalise(Mat M, const ConstTallRef& against, TallRef x, double drop = 1e-10);

}  // namespace ritz::petsc
