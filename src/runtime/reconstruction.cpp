#include "ritz/runtime/reconstruction.hpp"

#include "row_products.hpp"

namespace ritz::runtime {

void reconstruct(const model::Basis& basis, Eigen::Ref<const Eigen::VectorXd> z, model::Points& displacements) {
  multiply_rows(basis.U.data(), basis.U.rows(), basis.U.cols(), z.data(), displacements.data());
}

Eigen::MatrixXd mean_rows(const model::Basis& basis, std::span<const std::int64_t> rows) {
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, basis.U.cols());
  for (const auto row : rows) mean += basis.U.middleRows<3>(3 * row);
  return mean / static_cast<double>(rows.size());
}

}  // namespace ritz::runtime
