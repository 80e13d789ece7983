// Tall matrices (distributed rows, few columns) and their products.
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// This rank's rows of a tall matrix, column-major; the columns are whole on each rank.
using Tall = Eigen::MatrixXd;
using TallRef = Eigen::Ref<Eigen::MatrixXd>;
using ConstTallRef = Eigen::Ref<const Eigen::MatrixXd>;

/// y = A x. *Collective* on A.
void multiply(Mat A, const ConstTallRef& x, TallRef y);
Tall multiply(Mat A, const ConstTallRef& x);

/// xᵀ y (small, the same on all ranks). *Collective*.
Eigen::MatrixXd inner(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& y);

/// x c, and y -= x c: combinations of columns by BLAS.
Tall combine(const ConstTallRef& x, const Eigen::MatrixXd& c);
void subtract(TallRef y, const ConstTallRef& x, const Eigen::MatrixXd& c);

/// x ← x L⁻ᵀ of a Gram matrix xᵀMx = L Lᵀ: the columns become M-orthonormal. A rank may have no rows.
void normalise(TallRef x, const Eigen::LLT<Eigen::MatrixXd>& gram);

/// Column norms ‖x_j‖₂. *Collective*.
Eigen::VectorXd column_norms(MPI_Comm comm, const ConstTallRef& x);

/// The local rows x (contiguous columns) seen as a dense PETSc matrix; x must outlive it.
Matrix as_dense(MPI_Comm comm, TallRef x);

/// Copies of the columns as PETSc vectors that fit A. *Collective*.
std::vector<Vector> as_vectors(Mat A, const ConstTallRef& x);

/// M-orthonormalises x against the M-orthonormal columns of `against` (may have none) and within itself: twice, and
/// once more where much was taken away in the second pass. Directions whose M-norm falls below `drop` times what it was
/// are removed: returns how many columns are left (they stand first). *Collective*.
int orthonormalise(Mat M, const ConstTallRef& against, TallRef x, double drop = 1e-10);

/// values.row(i) is added to row numbers[i] (global) of a tall matrix of which this rank owns `owned` rows; returns the
/// owned rows. *Collective*.
Tall accumulate(MPI_Comm comm, std::span<const std::int64_t> numbers, const ConstTallRef& values, int owned);

}  // namespace ritz::petsc
