// Dense algebra that results are measured with: Eigen's own, compiled once.
#pragma once
#include <Eigen/Core>

namespace ritz::test {

/// The sine of the largest principal angle between the spans of M-orthonormal columns: ‖(I − A AᵀM) B‖_M.
double largest_sine(const Eigen::MatrixXd& M, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// All eigenvalues of K ψ = λ M ψ, ascending, and M-orthonormal vectors.
struct DenseModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
DenseModes dense_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

/// Singular values, descending, and left singular vectors.
struct DenseSvd {
  Eigen::VectorXd values;
  Eigen::MatrixXd left;
};
DenseSvd dense_svd(const Eigen::MatrixXd& A);

/// Ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

}  // namespace ritz::test
