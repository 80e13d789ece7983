#include "ritz/stages/rayleigh_ritz.hpp"

#include <limits>

#include "ritz/algebra/dense.hpp"

namespace ritz::stages {

RitzPairs rayleigh_ritz(const algebra::Matrix& K, const algebra::Matrix& M, const algebra::ConstTallRef& against,
                        algebra::Tall x) {
  const int kept = algebra::orthonormalise(M, against, x);
  const auto basis = x.leftCols(kept);
  const Eigen::MatrixXd product = algebra::inner(algebra::comm_of(K), basis, algebra::multiply(K, basis));
  auto [values, vectors] = algebra::symmetric_eigen((product + product.transpose()) / 2);
  return {std::move(values), algebra::combine(basis, vectors)};
}

Residuals residuals(const algebra::Matrix& K, const algebra::Matrix& M, double norm_K, const RitzPairs& pairs) {
  const MPI_Comm comm = algebra::comm_of(K);
  const algebra::Tall mx = algebra::multiply(M, pairs.vectors);
  algebra::Tall r = algebra::multiply(K, pairs.vectors);
  r -= mx * pairs.values.asDiagonal();
  const Eigen::ArrayXd scale = pairs.values.array().abs() * algebra::column_norms(comm, mx).array();
  const Eigen::ArrayXd floor =
      10 * std::numeric_limits<double>::epsilon() * norm_K * algebra::column_norms(comm, pairs.vectors).array() / scale;
  return {algebra::column_norms(comm, r).array() / scale, floor.max(residual_gate), std::move(r)};
}

}  // namespace ritz::stages
