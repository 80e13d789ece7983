#include "eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace ritz::runtime {

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace ritz::runtime
