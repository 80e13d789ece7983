// Eigenvalues and vectors of small symmetric matrices, by LAPACK: compiled once, where Eigen's are in every caller.
#pragma once
#include <Eigen/Core>

namespace ritz::petsc {

struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};

/// Of A, whose lower triangle is read. Throws NumericalError where LAPACK gives up.
SymmetricEigen symmetric_eigen(Eigen::MatrixXd A);

/// The values alone. Throws as above.
Eigen::VectorXd symmetric_eigenvalues(Eigen::MatrixXd A);

}  // namespace ritz::petsc
