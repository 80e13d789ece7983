// Decompositions and products of small matrices by LAPACK and BLAS. These are compiled once, while Eigen's would be in
// every caller.
#pragma once
#include <Eigen/Core>

namespace ritz::algebra {

/// The eigenvalues and eigenvectors of a small symmetric matrix.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};

/// The decomposition of A, of which only the lower triangle is read. Throws NumericalError when LAPACK fails.
SymmetricEigen symmetric_eigen(Eigen::MatrixXd A);

/// The eigenvalues alone, ascending. Throws NumericalError as above.
Eigen::VectorXd symmetric_eigenvalues(Eigen::MatrixXd A);

/// Singular values of a small matrix, accurate to rounding errors of the largest, and singular vectors of one side.
struct SingularVectors {
  Eigen::VectorXd sigma;  ///< descending, min(rows, columns) of them
  Eigen::MatrixXd vectors;
};

/// With the left vectors, one for each σ. Throws NumericalError when LAPACK fails.
SingularVectors left_singular_vectors(Eigen::MatrixXd A);

/// With all right vectors: those after the last σ span the null space. Throws NumericalError as above.
SingularVectors right_singular_vectors(Eigen::MatrixXd A);

/// The orthogonal matrix nearest to a square A, its polar factor: U Vᵀ for A = U Σ Vᵀ. Throws NumericalError as above.
Eigen::MatrixXd nearest_orthogonal(Eigen::MatrixXd A);

/// c = α op(a) b + β c by `dgemm`, with op the transpose for 'T' and nothing for 'N'. Where there is nothing to sum
/// over, c stays. On this rank alone; allocates nothing.
void gemm(char op, double alpha, const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::Ref<const Eigen::MatrixXd>& b,
          double beta, Eigen::Ref<Eigen::MatrixXd> c);

/// Adds y yᵀ to the upper triangle of `gram` (one `dsyrk`) and leaves the lower triangle as it is. On this rank alone.
void add_gram(Eigen::Ref<Eigen::MatrixXd> gram, const Eigen::Ref<const Eigen::MatrixXd>& y);

}  // namespace ritz::algebra
