#pragma once
#include <Eigen/Core>

namespace ritz::runtime {

/// The eigenvalues of a symmetric matrix, ascending.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
/// The eigenvalues λ of `symmetric` x = λ `mass` x, ascending; the mass is positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& mass);

}  // namespace ritz::runtime
