#pragma once
#include <Eigen/Core>

namespace ritz::runtime {

/// The eigenvalues of a symmetric matrix, ascending.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
/// Those of `symmetric` x = λ `mass` x, with a positive definite mass.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric, const Eigen::MatrixXd& mass);

}  // namespace ritz::runtime
