// Decompositions and products of small matrices by LAPACK and BLAS: compiled once, where Eigen's are in every caller.
#pragma once
#include <Eigen/Core>

namespace ritz::petsc {

/// Of a small symmetric matrix.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};

/// Of A, whose lower triangle is read. Throws NumericalError where LAPACK gives up.
SymmetricEigen symmetric_eigen(Eigen::MatrixXd A);

/// The values alone. Throws as above.
Eigen::VectorXd symmetric_eigenvalues(Eigen::MatrixXd A);

/// Of a small matrix; right to rounding of the largest σ.
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

/// The upper triangle of `gram` += y yᵀ, one `dsyrk`; the lower triangle is not touched. On this rank alone.
void add_gram(Eigen::Ref<Eigen::MatrixXd> gram, const Eigen::Ref<const Eigen::MatrixXd>& y);

}  // namespace ritz::petsc
