// Eigenvalues of small dense symmetric matrices, by Eigen, which takes long to compile and is compiled here alone.
#pragma once
#include <Eigen/Core>

namespace ritz::runtime {

/// A = V diag(λ) Vᵀ with VᵀV = I.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< λ, ascending
  Eigen::MatrixXd vectors;  ///< V, a column for each value
};

/// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& symmetric);
/// The eigenvalues alone, ascending.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
/// The eigenvalues λ of `symmetric` x = λ `mass` x, ascending; the mass is positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& mass);

}  // namespace ritz::runtime
