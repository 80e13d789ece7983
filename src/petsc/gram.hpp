// Sums of outer products by BLAS.
#pragma once
#include <Eigen/Core>

namespace ritz::petsc {

/// The upper triangle of `gram` += y yᵀ, one `dsyrk`; the lower triangle is not touched. On this rank alone.
void add_gram(Eigen::Ref<Eigen::MatrixXd> gram, const Eigen::Ref<const Eigen::MatrixXd>& y);

}  // namespace ritz::petsc
