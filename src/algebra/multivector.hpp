// Tall matrices (distributed rows, few columns) and their products.
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {

/// This rank's rows of a tall matrix, column-major. All ranks have the same number of columns.
using Tall = Eigen::MatrixXd;
using TallRef = Eigen::Ref<Eigen::MatrixXd>;
using ConstTallRef = Eigen::Ref<const Eigen::MatrixXd>;

/// y = A x. *Collective* on A.
void multiply(Mat A, const ConstTallRef& x, TallRef y);
Tall multiply(Mat A, const ConstTallRef& x);

/// *Collective*. xᵀ y, a small matrix, replicated on all ranks.
Eigen::MatrixXd inner(MPI_Comm comm, const ConstTallRef& x, const ConstTallRef& y);

/// x c, and y -= x c: linear combinations of columns by BLAS, on this rank's rows.
Tall combine(const ConstTallRef& x, const Eigen::MatrixXd& c);
void subtract(TallRef y, const ConstTallRef& x, const Eigen::MatrixXd& c);

/// x := x L⁻ᵀ for the Gram matrix xᵀMx = L Lᵀ, which makes the columns M-orthonormal. A rank may have no rows.
void normalise(TallRef x, const Eigen::LLT<Eigen::MatrixXd>& gram);

/// *Collective*. The norms ‖x_j‖₂ of the columns.
Eigen::VectorXd column_norms(MPI_Comm comm, const ConstTallRef& x);

/// A dense PETSc matrix that shares the memory of the local rows x (contiguous columns); x must outlive it.
Matrix as_dense(MPI_Comm comm, TallRef x);

/// *Collective*. The columns, copied into PETSc vectors that are compatible with A.
std::vector<Vector> as_vectors(Mat A, const ConstTallRef& x);

/// *Collective*. M-orthonormalises x against the M-orthonormal columns of `against` (which may have none) and within
/// itself: in two passes, and a third if the second still removed much. Columns whose M-norm falls below `drop` times
/// its initial value are removed. Returns the number of columns that are left; they come first.
int orthonormalise(Mat M, const ConstTallRef& against, TallRef x, double drop = 1e-10);

/// *Collective*. Adds values.row(i) to row numbers[i] (global) of a tall matrix of which this rank owns `owned` rows;
/// returns the owned rows.
Tall accumulate(MPI_Comm comm, std::span<const std::int64_t> numbers, const ConstTallRef& values, int owned);

}  // namespace ritz::algebra
