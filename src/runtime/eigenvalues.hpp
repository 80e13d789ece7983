#pragma once
#include <Eigen/Core>

namespace ritz::runtime {

/// Of a symmetric matrix, ascending: its smallest tells a limit point, its largest the longest explicit step.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

}  // namespace ritz::runtime
