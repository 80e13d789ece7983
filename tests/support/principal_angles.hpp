// How far two subspaces are apart.
#pragma once
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace ritz::test {

/// The sine of the largest principal angle between the spans of M-orthonormal columns: ‖(I − A AᵀM) B‖_M.
inline double largest_sine(const Eigen::MatrixXd& M, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::MatrixXd rest = B - A * (A.transpose() * (M * B));
  const Eigen::MatrixXd gram = rest.transpose() * M * rest;
  return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram).eigenvalues().maxCoeff()));
}

}  // namespace ritz::test
