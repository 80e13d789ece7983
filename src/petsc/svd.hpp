// Singular values and vectors of small matrices, by LAPACK: right to rounding of the largest.
#pragma once
#include <Eigen/Core>

namespace ritz::petsc {

struct SingularVectors {
  Eigen::VectorXd sigma;  ///< descending, min(rows, columns) of them
  Eigen::MatrixXd vectors;
};

/// The left vectors, as many as there are σ. Throws NumericalError where LAPACK gives up.
SingularVectors left_singular_vectors(Eigen::MatrixXd A);

/// The right vectors, all of them: those behind the last σ span the null space. Throws as above.
SingularVectors right_singular_vectors(Eigen::MatrixXd A);

/// The orthogonal matrix nearest to a square A: U Vᵀ of A = U Σ Vᵀ, its polar factor. Throws as above.
Eigen::MatrixXd nearest_orthogonal(Eigen::MatrixXd A);

}  // namespace ritz::petsc
